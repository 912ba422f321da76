// The corner trick, and how to break it.
"use strict";

live("ch10-corner-trick", {
  title: "use the corner trick, and break it",
  ask: "The trick looks only into cells that reach outside of a circle. When "
    + "is its answer wrong?",
  choices: ["Never", "When the furthest cell is empty",
    "When two points are equally far"],
  because: "When the furthest cell is empty: then the circle "
    + "through its corner promises a point that is not there.",

  show: function (stage) {
    var c = stage.c, points = c.generate("uniform", 60, 5), put = false;
    var query = 0;
    var p = draw.plane(stage, "60 points in a grid of cells. Click, or arrow "
      + "keys and Enter, to choose the query, or to put and remove points.",
      act);
    var list = draw.list(stage, "The points in words");

    function nearest_to(x, y) {
      var best = 0;
      points.forEach(function (q, i) {
        if (Math.hypot(q[0] - x, q[1] - y) < Math.hypot(points[best][0] - x,
          points[best][1] - y)) best = i;
      });
      return best;
    }

    function act(x, y) {
      var i = nearest_to(x, y), d = Math.hypot(points[i][0] - x,
        points[i][1] - y), words = "The query is point " + i + ", at "
        + draw.place(points[i]) + ".";
      if (!put) query = i;
      else if (d < 0.02 && points.length > 3) {
        points.splice(i, 1);
        if (query >= i && query > 0) query--;
        words = "Point " + i + " removed.";
      } else {
        points.push([x, y]);
        words = "Point " + (points.length - 1) + " put at "
          + draw.place([x, y]) + ".";
      }
      redraw();
      return words;
    }

    function ask() {
      var n = points.length, q = points[query];
      c.points(points);
      c.set_geometry(1, 1, 1);
      c.sort_cells(3);
      c.ask_one_corner();
      var a = { n: n, columns: c.columns(), rows: c.rows(), cells: [],
        found: c.u32(c.furthest(), n), found2: c.f64(c.furthest2(), n),
        x: c.f64(c.column_border(), c.columns() + 1),
        y: c.f64(c.row_border(), c.rows() + 1),
        start: c.u32(c.start(), c.columns() * c.rows() + 1),
        radius: Math.sqrt(c.corner_radius2(q[0], q[1])) };
      for (var r = 0; r < a.rows; r++) {
        for (var k = 0; k < a.columns; k++) {
          if (c.corner_visits(q[0], q[1], k, r)) a.cells.push([k, r]);
        }
      }
      c.by("naive");
      a.right = c.u32(c.furthest(), n);
      a.right2 = c.f64(c.furthest2(), n);
      return a;
    }

    function wrong(a) {
      return points.filter(function (_, i) {
        return a.found2[i] !== a.right2[i];
      }).length;
    }

    function redraw() {
      var a = ask(), q = points[query];
      p.frame();
      a.cells.forEach(function (k) {
        p.area([a.x[k[0]], a.y[k[1]]], [a.x[k[0] + 1], a.y[k[1] + 1]], "wash");
      });
      a.x.forEach(function (x) {
        p.segment([x, a.y[0]], [x, a.y[a.rows]], "grid");
      });
      a.y.forEach(function (y) {
        p.segment([a.x[0], y], [a.x[a.columns], y], "grid");
      });
      p.circle(q, a.radius, "ring");
      points.forEach(function (b) { p.dot(b, "dot", 3); });
      p.segment(q, points[a.right[query]], "wrong");
      if (a.found[query] < a.n) p.segment(q, points[a.found[query]], "stroke");
      p.dot(q, "query", 6);
      p.cross();
      var good = a.found2[query] === a.right2[query];
      list(points.map(function (b, i) {
        return "Point " + i + " at " + draw.place(b) + (i === query
          ? ": the query" : "") + (i === a.right[query] ? ": the furthest" : "")
          + (i === a.found[query] ? ": the trick's answer" : "");
      }));
      function far(i, square) {
        return "point " + i + ", " + Math.sqrt(square).toFixed(3) + " away";
      }
      stage.say("The trick looks into " + a.cells.length + " of "
        + a.columns * a.rows + " cells, and is " + (good ? "right here: "
        + far(a.right[query], a.right2[query]) : "wrong here: "
        + (a.found[query] < a.n ? "it finds " + far(a.found[query],
        a.found2[query]) : "it finds none") + ", but the orange line leads to "
        + far(a.right[query], a.right2[query])) + "; of all " + a.n
        + " queries it is wrong for " + wrong(a) + ".");
    }

    stage.choice("A click", ["chooses the query", "puts or removes a point"],
      function (k) { put = k === 1; });
    stage.button("Break it", function () { points = broken(); redraw(); });
    stage.button("Other points", function () {
      points = c.generate("uniform", 60, 1 + Math.floor(Math.random() * 1e6));
      query = 0;
      redraw();
    });
    redraw();

    // A corner of the square is cut off, and its cells are empty. The
    // query is the first that is deceived.
    function broken() {
      points = c.generate("uniform", 100, 2).filter(function (q) {
        return q[0] + q[1] < 1.25;
      });
      query = 0;
      var a = ask();
      query = Math.max(0, points.findIndex(function (_, i) {
        return a.found2[i] !== a.right2[i];
      }));
      return points;
    }

    // Right where no cell is empty, and wrong somewhere when broken.
    return { check: function () {
      var kept = points, asked = query, good = true, tried = 0;
      for (var seed = 1; seed <= 30; seed++) {
        points = c.generate("uniform", 90, seed);
        query = 0;
        var a = ask(), full = true;
        for (var k = 0; k + 1 < a.start.length; k++) {
          if (a.start[k] === a.start[k + 1]) full = false;
        }
        if (full) { tried++; if (wrong(a)) good = false; }
      }
      points = broken();
      var breaks = wrong(ask()) > 0;
      points = kept;
      query = asked;
      redraw();
      return good && tried > 0 && breaks;
    } };
  }
});
