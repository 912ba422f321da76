// A spiral search, cell by cell, for any point that you choose.
"use strict";

live("ch07-search", {
  title: "follow a spiral search, cell by cell",
  ask: "144 points lie in 144 cells. How many cells does the search of the "
    + "point near the middle visit?",

  show: function (stage) {
    var N = 144, c = stage.c, points, self = 0, trace = [], seed = 7;
    var p = draw.plane(stage, "144 points in a grid of cells. Click, or move "
      + "the cross with the arrow keys and press Enter, to choose a query.",
      choose);
    var list = draw.list(stage, "The points in words");

    function prepare() {
      points = c.generate("uniform", N, seed);
      c.set_geometry(1, 1, 1);
      c.sort_cells(1);
      grid = { m: c.columns(), x: c.f64(c.column_border(), c.columns() + 1),
        y: c.f64(c.row_border(), c.rows() + 1) };
      list(points.map(function (q, i) {
        return "Point " + i + " at " + draw.place(q);
      }));
    }

    var grid;
    function choose(x, y) {
      var best = Infinity;
      points.forEach(function (q, i) {
        var d = Math.hypot(q[0] - x, q[1] - y);
        if (d < best) { best = d; self = i; }
      });
      trace = search(self);
      walk.go(0);
      return "The query is point " + self + ", at " + draw.place(points[self])
        + ".";
    }

    function search(i) {
      var n = c.spiral_cells(i), cell = c.u32(c.visited_cell(), n);
      var compared = c.u32(c.visited_points(), n);
      var nearest = c.u32(c.visited_nearest(), n);
      return Array.from(cell, function (k, j) {
        return { column: k % grid.m, row: Math.floor(k / grid.m),
          compared: compared[j],
          nearest: nearest[j] === 0xFFFFFFFF ? null : nearest[j] };
      });
    }

    function layer(v) {
      return Math.max(Math.abs(v.column - trace[0].column),
        Math.abs(v.row - trace[0].row));
    }

    // Phase one ends with the first layer in which there was a point.
    function phase_one() {
      var found = trace.findIndex(function (v) { return v.nearest !== null; });
      return trace.filter(function (v) {
        return layer(v) <= layer(trace[found]);
      }).length;
    }

    function show(k) {
      var first = phase_one(), sum = 0;
      p.frame();
      for (var i = 0; i < k; i++) {
        var v = trace[i], low = [grid.x[v.column], grid.y[v.row]];
        sum += v.compared;
        p.area(low, [grid.x[v.column + 1], grid.y[v.row + 1]],
          i < first ? "wash" : "warm");
        var at = p.at([low[0], grid.y[v.row + 1]]);
        p.add("text", { x: at[0] + 4, y: at[1] + 12, "class": "small" }, i + 1);
      }
      grid.x.forEach(function (x) { p.segment([x, grid.y[0]],
        [x, grid.y[grid.y.length - 1]], "grid"); });
      grid.y.forEach(function (y) { p.segment([grid.x[0], y],
        [grid.x[grid.m], y], "grid"); });
      points.forEach(function (q) { p.dot(q, "dot", 3); });
      p.dot(points[self], "query", 6);
      var now = k ? trace[k - 1] : null, q = points[self], d;
      if (now && now.nearest !== null) {
        var b = points[now.nearest];
        d = Math.hypot(b[0] - q[0], b[1] - q[1]);
        p.segment(q, b, "stroke");
        if (k >= first) p.area([q[0] - d, q[1] - d], [q[0] + d, q[1] + d], "ring");
      }
      p.cross();
      stage.say(k === 0 ? "The search of the marked point, " + self + ", in "
        + trace.length + " cells." : "Cell " + k + " of " + trace.length
        + ", in column " + now.column + " and row " + now.row + ", layer "
        + layer(now) + ", phase " + (k <= first ? "one" : "two") + ": "
        + now.compared + " compared there, " + sum + " in all; "
        + (now.nearest === null ? "no point yet." : "the nearest so far is "
        + "point " + now.nearest + ", " + d.toFixed(3) + " away."));
    }

    var walk = draw.steps(stage, function () { return trace.length; }, show);
    stage.button("Other points", function () {
      seed++;
      prepare();
      choose(0.5, 0.5);
    });
    prepare();
    choose(0.5, 0.5);
    stage.say("It visits " + trace.length + " cells; you said "
      + stage.predicted + ". Go through them.");

    return { check: function () {
      c.by("naive");
      var right = c.u32(c.nearest(), N);
      return points.every(function (_, i) {
        var t = search(i);
        return t[t.length - 1].nearest === right[i];
      });
    } };
  }
});
