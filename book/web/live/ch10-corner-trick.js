// The corner trick, and how to break it.
"use strict";

live("ch10-corner-trick", {
  title: "use the corner trick, and break it",
  ask: "The trick looks only into cells with a part outside of a circle. "
    + "What must be so for its answer to be wrong?",
  choices: ["The furthest corner cell is empty, and that is enough",
    "No point at all is outside of the circle",
    "Two points are equally far"],
  because: "It can be wrong only if no point at all is outside of the circle: a "
    + "point outside is in a cell that is searched, and is further than all "
    + "inside. Below, the corner cell is empty, and the trick is right all the "
    + "same. Take the furthest point away until none is outside.",

  show: function (stage) {
    var M = 8, N = 128, c = stage.c, kind = 0, seed = 68, put = false, query = 0;
    var kinds = ["uniform", "clustered", "kuzmin", "circle"], points, now;
    var names = ["uniform", "ten clusters", "Kuzmin’s disc", "on a circle"];
    var p = draw.plane(stage, "Points in a grid of 64 cells, the circle of the "
      + "corner trick, the cells that it searches, and what it finds.", act);
    stage.box.append(live.element("p", { "class": "hint" }, "The large dot is "
      + "the query. The small square is the inner corner of the corner cell "
      + "that is furthest from it; the circle goes through it. Blue cells have "
      + "a part outside of the circle and are searched; orange dots are points "
      + "outside. Line: to the answer of the trick. Orange dashes, if that is "
      + "wrong: to the furthest point. The grid stays where it is, "
      + "whatever you put or remove. A click chooses the nearest point as the "
      + "query, or puts or removes a point, as set below. By keyboard, in the "
      + "picture: the arrow keys (with Shift, larger steps) and Enter."));
    var list = draw.list(stage, "The points in words");

    // Points of a kind, stretched so that they fill the square, less a
    // little at the rim, where a click has to find them.
    function generate() {
      points = c.generate(kinds[kind], N, seed);
      var range = [0, 1].map(function (k) {
        var v = points.map(function (q) { return q[k]; });
        var low = Math.min.apply(0, v);
        return { low: low, size: Math.max.apply(0, v) - low || 1 };
      });
      points = points.map(function (q) {
        return range.map(function (r, k) {
          return 0.015 + 0.97 * (q[k] - r.low) / r.size;
        });
      });
      query = draw.nearest(points, 0.22, 0.3);
    }

    function act(x, y) {
      var i = draw.nearest(points, x, y), words;
      if (!put) {
        query = i;
        words = "The query is point " + i + ", at " + draw.place(points[i]) + ".";
      } else if (Math.hypot(points[i][0] - x, points[i][1] - y) > 0.02) {
        points.push([x, y]);
        words = "Point " + (points.length - 1) + " put at "
          + draw.place([x, y]) + ".";
      } else if (points.length > 2) {
        keep(function (_, k) { return k !== i; });
        words = "Point " + i + " removed.";
      } else words = "Two points have to stay.";
      redraw();
      return words;
    }

    // Keeps some points. The query stays, or else another is chosen.
    function keep(wanted) {
      var q = points[query];
      points = points.filter(wanted);
      query = Math.max(0, points.indexOf(q));
    }

    function take_furthest() {
      var j = now.right[query];
      keep(function (_, k) { return k !== j; });
    }

    function ask() {
      var n = points.length;
      c.points(points);
      c.set_geometry(1, 1, 1);
      c.sort_in_square(M, M);
      c.ask_one_corner();
      now = { n: n, found: c.u32(c.furthest(), n),
        found2: c.f64(c.furthest2(), n), start: c.u32(c.start(), M * M + 1) };
      c.by("naive");
      now.right = c.u32(c.furthest(), n);
      now.right2 = c.f64(c.furthest2(), n);
      return now;
    }

    function wrong(i) { return now.found2[i] !== now.right2[i]; }

    function all_wrong() {
      return points.map(function (_, i) { return i; }).filter(wrong);
    }

    // The cells that are searched for point i, the points outside of its
    // circle, and its corner cell.
    function circle(i) {
      var q = points[i], r2 = c.corner_radius2(q[0], q[1]), cells = [];
      for (var k = 0; k < M * M; k++) {
        if (c.corner_visits(q[0], q[1], k % M, Math.floor(k / M))) cells.push(k);
      }
      var corner = (q[1] < 0.5 ? M * (M - 1) : 0) + (q[0] < 0.5 ? M - 1 : 0);
      return { cells: cells, radius: Math.sqrt(r2),
        corner: now.start[corner + 1] - now.start[corner],
        at: [q[0] < 0.5 ? 1 - 1 / M : 1 / M, q[1] < 0.5 ? 1 - 1 / M : 1 / M],
        searched: cells.reduce(function (sum, k) {
          return sum + now.start[k + 1] - now.start[k];
        }, 0),
        outside: points.filter(function (b) { return is_outside(b, q, r2); }) };
    }

    function is_outside(b, q, radius2) {
      var x = b[0] - q[0], y = b[1] - q[1];
      return x * x + y * y > radius2;
    }

    function draw_all(o) {
      var q = points[query];
      p.frame();
      o.cells.forEach(function (k) {
        var x = k % M, y = Math.floor(k / M);
        p.area([x / M, y / M], [(x + 1) / M, (y + 1) / M], "wash");
      });
      for (var k = 1; k < M; k++) {
        p.segment([k / M, 0], [k / M, 1], "grid");
        p.segment([0, k / M], [1, k / M], "grid");
      }
      p.circle(q, o.radius, "ring");
      points.forEach(function (b) {
        p.dot(b, o.outside.includes(b) ? "outside" : "dot", 3.2);
      });
      if (wrong(query)) p.segment(q, points[now.right[query]], "wrong");
      if (now.found[query] < now.n) {
        p.segment(q, points[now.found[query]], "stroke");
      }
      p.area([o.at[0] - 0.011, o.at[1] - 0.011], [o.at[0] + 0.011,
        o.at[1] + 0.011], "corner");
      p.dot(q, "query", 6);
      p.cross();
      list(points.map(function (b, i) {
        return "Point " + i + " at " + draw.place(b) + (i === query
          ? ": the query" : "") + (i === now.right[query] ? ": the furthest" : "")
          + (i === now.found[query] ? ": the trick's answer" : "")
          + (o.outside.includes(b) ? ": outside of the circle" : "");
      }));
    }

    function verdict(o) {
      if (o.outside.length) {
        return draw.many(o.outside.length, "point") + (o.outside.length === 1
          ? " is" : " are") + " outside of the circle, so the trick must be "
          + "right.";
      }
      return "No point is outside of the circle. " + (!wrong(query)
        ? "Among the " + draw.many(o.searched, "point") + " of the blue cells the "
        + "furthest happens to be: right, by luck." : "The trick is wrong: "
        + (now.found[query] < now.n ? "the best of the blue cells, "
        + Math.sqrt(now.found2[query]).toFixed(3) + " away, is not as far as a "
        + "point that is " + Math.sqrt(now.right2[query]).toFixed(3)
        + " away, in a cell that it does not search."
        : "its blue cells have no point."));
    }

    function redraw() {
      ask();
      var o = circle(query), w = all_wrong().length;
      draw_all(o);
      stage.say("The corner cell has " + (o.corner ? draw.many(o.corner, "point")
        : "no point") + ". " + verdict(o) + " It searches " + o.cells.length
        + " of " + M * M + " cells here. Of the " + now.n
        + " points as queries, it is wrong for " + (w ? w : "none") + ".");
    }

    stage.choice("A click", ["chooses the query", "puts or removes a point"],
      function (k) { put = k === 1; });
    stage.button("Take the furthest away", function () {
      if (points.length > 2) take_furthest();
      redraw();
    });
    stage.button("Next wrong query", function () {
      var bad = all_wrong();
      if (!bad.length) return stage.say("There is none: all answers are right.");
      var next = bad.find(function (i) { return i > query; });
      query = next === undefined ? bad[0] : next;
      redraw();
    });
    stage.choice("Points", names, function (k) {
      kind = k;
      generate();
      redraw();
    });
    stage.button("Other points", function () { seed++; generate(); redraw(); });

    // The example: an empty corner cell, which the trick survives.
    function empty_corner() {
      kind = 0;
      seed = 68;
      generate();
      ask();
      keep(function (b) { return b[0] <= 1 - 1 / M || b[1] <= 1 - 1 / M; });
      redraw();
    }
    empty_corner();

    function state() {
      var o = circle(query);
      return { corner: o.corner, wrong: wrong(query),
        outside: o.outside.length };
    }

    // Right wherever a point is outside; wrong somewhere in each kind but
    // the first, and in the example once no point is outside.
    return { state: state, asked: function () { // an empty corner, and right
      return state().corner === 0 && state().outside > 0 && !state().wrong;
    }, check: function () {
      var good = true, o, before, errs;
      for (kind = 0; kind < kinds.length; kind++) {
        errs = 0;
        for (seed = 1; seed <= 10; seed++) {
          generate();
          ask();
          points.forEach(function (_, i) {
            if (wrong(i)) errs++;
            if (wrong(i) && circle(i).outside.length) good = false;
          });
        }
        if (kind > 0 && errs === 0) good = false;
      }
      empty_corner();
      o = circle(query);
      before = o.corner === 0 && o.outside.length > 0 && !wrong(query);
      for (var k = o.outside.length; k > 0; k--) { take_furthest(); ask(); }
      good = good && before && wrong(query);
      empty_corner();
      return good;
    } };
  }
});
