// What an octagon leaves over, and the corners of the hull.
"use strict";

live("ch10-octagon", {
  title: "throw points away with an octagon",
  ask: "Of 1,000 uniform points in a square, how many are corners of their "
    + "convex hull, so that they are the furthest of all from somewhere in "
    + "the plane?",

  show: function (stage) {
    var N = 1000, c = stage.c, kinds = ["uniform", "kuzmin", "circle",
      "clustered", "lattice"], names = ["uniform", "Kuzmin’s disc",
      "on a circle", "ten clusters", "lattice"], query = null;
    var kind = 0, seed = 1, points = [], now = {};
    var p = draw.plane(stage, "1,000 points, the octagon between those that are "
      + "furthest out in eight directions, and the corners of their convex "
      + "hull.", act);
    stage.box.append(live.element("p", { "class": "hint" }, "Faint dots: thrown "
      + "away, deeper inside of the octagon than its margin (which is too "
      + "narrow to be drawn). Small full dots: kept. Large dots: corners of "
      + "the hull. Rings: the points furthest out in one of eight directions. "
      + "Click, or in the picture use the arrow keys (with Shift, larger steps) "
      + "and Enter: a line goes from that place to the furthest point."));
    var list = draw.list(stage, "The corners in words");

    function scaled(list) {
      var x = list.map(function (q) { return q[0]; });
      var y = list.map(function (q) { return q[1]; });
      var low = [Math.min.apply(0, x), Math.min.apply(0, y)];
      var size = Math.max(Math.max.apply(0, x) - low[0],
        Math.max.apply(0, y) - low[1]) || 1;
      return list.map(function (q) {
        return [(q[0] - low[0]) / size, (q[1] - low[1]) / size];
      });
    }

    // All from the C: what is left, the corners, and who is the furthest
    // of one of these points.
    function ask() {
      points = scaled(c.generate(kinds[kind], N, seed));
      c.points(points);
      c.set_geometry(1, 1, 1);
      var left = c.octagon(), kept = new Set(c.u32(c.outside_octagon(), left));
      var sides = octagon(), n = c.hull();
      now = { kept: kept, sides: sides,
        corners: new Set(c.u32(c.hull_corner(), n)) };
      c.by("furthest-hull");
      now.furthest = new Set(c.u32(c.furthest(), N));
      list(Array.from(now.corners, function (i) {
        return "Corner at " + draw.place(points[i]) + (now.furthest.has(i)
          ? ": the furthest of some of the points" : "");
      }));
      return now;
    }

    // The octagon: the unit square, cut by each side a x + b y > c.
    function octagon() {
      var a = c.f64(c.side_a(), 8), b = c.f64(c.side_b(), 8);
      var s = c.f64(c.side_c(), 8), left = c.side_left();
      var bottom = c.side_bottom(), shape = [[0, 0], [1, 0], [1, 1], [0, 1]];
      for (var k = 0; k < 8; k++) {
        var cut = [];
        shape.forEach(function (q, i) {
          var r = shape[(i + 1) % shape.length];
          var f = a[k] * (q[0] - left) + b[k] * (q[1] - bottom) - s[k];
          var g = a[k] * (r[0] - left) + b[k] * (r[1] - bottom) - s[k];
          if (f >= 0) cut.push(q);
          if (f >= 0 !== g >= 0) {
            cut.push([q[0] + (r[0] - q[0]) * f / (f - g),
              q[1] + (r[1] - q[1]) * f / (f - g)]);
          }
        });
        shape = cut;
      }
      return shape;
    }

    function distance(i, q) {
      return Math.hypot(points[i][0] - q[0], points[i][1] - q[1]);
    }

    function furthest_from(q) {
      return points.reduce(function (best, _, i) {
        return distance(i, q) > distance(best, q) ? i : best;
      }, 0);
    }

    // Points that are furthest out are corners of the octagon; equal
    // corners of it are one.
    function rings() {
      now.sides.forEach(function (q) { p.circle(q, 0.017, "mark"); });
    }

    function count() { return now.corners.size; }

    var said = [
      function () { return "The 1,000 points."; },
      function () {
        return "1 and 2, measure and look again: the points that are furthest "
          + "out in eight directions. One may be it in several.";
      },
      function () { return "3, make the sides of the octagon between them."; },
      function () {
        return "4, keep what is not inside: " + now.kept.size
          + " of 1,000 points. " + (now.kept.size === N ? "All of them: an "
          + "octagon does not help here." : "The others are thrown away without a sort.");
      },
      function () {
        return "Of 1,000 points the octagon keeps " + now.kept.size + ", and "
          + count() + " of these are corners of the hull. From the 1,000 points "
          + "themselves only " + now.furthest.size + " of the corners are the "
          + "furthest; the others are, from elsewhere in the plane.";
      }];

    function dots(step) {
      var thrown = step >= 3;
      points.forEach(function (q, i) {
        if (thrown && !now.kept.has(i)) p.dot(q, "faint", 1.8);
      });
      points.forEach(function (q, i) {
        if (!thrown) p.dot(q, "dot", 1.8);
        else if (step === 3 && now.kept.has(i)) p.dot(q, "dot", 3);
        else if (now.kept.has(i) && !now.corners.has(i)) p.dot(q, "dot", 2.5);
      });
      if (step < 4) return;
      now.corners.forEach(function (i) { p.dot(points[i], "query", 4.5); });
    }

    function draw_step(step) {
      p.frame();
      if (step >= 2) {
        p.add("polygon", { points: now.sides.map(function (q) {
          return p.at(q).join(",");
        }).join(" "), "class": "wash line" });
      }
      dots(step);
      if (step >= 1) rings();
      if (query) {
        var best = furthest_from(query);
        p.segment(query, points[best], "stroke");
        p.dot(query, "place", 4);
      }
      p.cross();
      stage.say(said[step]());
    }

    function act(x, y) {
      query = [x, y];
      walk.go(4);
      var i = furthest_from(query), words = "From the place you chose the "
        + "furthest point is " + (now.corners.has(i) ? "a corner"
        : "no corner of the hull") + ", " + (now.furthest.has(i) ? "which is "
        + "the furthest of some of the points, too. " : "though the furthest of "
        + "none of the points. ");
      stage.say(words + stage.status.textContent);
      return words;
    }

    function redraw() {
      query = null;
      ask();
      walk.go(4);
    }

    var walk = draw.steps(stage, function () { return 4; }, draw_step);
    stage.choice("Points", names, function (k) { kind = k; redraw(); });
    stage.button("Other points", function () {
      seed++;
      redraw();
      if (kinds[kind] === "lattice") {
        stage.say("There is only one lattice. " + stage.status.textContent);
      }
    });
    redraw();
    stage.answer.textContent = "You said " + stage.predicted
      + (stage.predicted === count() ? ", and so it is." : ". There are "
      + count() + ".");

    // Wraps a band around all points: the next corner is the one that has
    // no other to the right of the way there.
    function wrapped() {
      var first = points.reduce(function (best, q, i) {
        return q[0] < points[best][0] ? i : best;
      }, 0), at = first, count = 0;
      do {
        at = points.reduce(function (next, q, i) {
          var a = points[at], b = points[next];
          return i !== at && (next === at || (b[0] - a[0]) * (q[1] - a[1])
            - (b[1] - a[1]) * (q[0] - a[0]) < 0) ? i : next;
        }, at);
        count++;
      } while (at !== first && count <= N);
      return count;
    }

    // The furthest of a point is a corner, and was left over; so is the
    // furthest from any place. The naive furthest are the same, and of
    // uniform points there are as many corners as a band has.
    return { asked: function () { // the number can be read
      return stage.status.textContent.includes(count() + " of these are corners");
    }, check: function () {
      var before = kind, good = true;
      for (kind = 0; kind < kinds.length; kind++) {
        ask();
        c.by("naive");
        var naive = new Set(c.u32(c.furthest(), N));
        if (naive.size !== now.furthest.size) good = false;
        if (kind === 0 && wrapped() !== count()) good = false;
        for (var k = 0; k < 200; k++) {
          naive.add(furthest_from([(k * 0.618) % 1, (k * 0.733) % 1]));
        }
        naive.forEach(function (j) {
          if (!now.corners.has(j) || !now.kept.has(j)) good = false;
        });
      }
      kind = before;
      redraw();
      return good;
    } };
  }
});
