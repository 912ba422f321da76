// Crowds, and the pieces that they are cut into.
"use strict";

live("ch11-pieces", {
  title: "crowds, and the partition that adapts",
  ask: "20,000 points lie in ten clusters. Where will the pieces be small?",
  choices: ["Everywhere alike", "Where points crowd", "Where there are few"],
  because: "Where points crowd: a piece is cut again until its points "
    + "are spread evenly, so small pieces stand where many points are.",

  show: function (stage) {
    var N = 20000, c = stage.c, seed = 1, kind = 0, grids = false;
    var kinds = ["clustered", "uniform", "two-clusters", "kuzmin", "towns",
      "spiral", "log-normal"];
    var p = draw.plane(stage, "20,000 points, and the regions of the pieces "
      + "that they are cut into.");

    function pieces() {
      var list = [];
      c.cut_pieces();
      for (var leaf = 0; leaf < c.leaves(); leaf++) {
        var first = c.first_piece(leaf);
        for (var k = first; k < first + c.piece_count(leaf); k++) {
          var columns = c.piece_columns(k), rows = c.piece_rows(k);
          list.push({ region: c.f64(c.piece_region(k), 4),
            points: c.piece_points(k),
            x: columns ? c.f64(c.piece_column_border(k), columns + 1) : [],
            y: rows ? c.f64(c.piece_row_border(k), rows + 1) : [] });
        }
      }
      return list;
    }

    // The window: where all but the outermost hundredth of the points are.
    function range(values) {
      var s = Float64Array.from(values).sort(), m = s.length;
      var low = s[Math.floor(m * 0.005)], high = s[Math.floor(m * 0.995)];
      return [low, Math.max(high - low, 1e-9)];
    }

    function redraw() {
      var points = c.generate(kinds[kind], N, seed), list = pieces();
      var rx = range(points.map(function (q) { return q[0]; }));
      var ry = range(points.map(function (q) { return q[1]; }));
      function clip(v) { return Math.min(1, Math.max(0, v)); }
      function at(x, y) { return [clip((x - rx[0]) / rx[1]), clip((y - ry[0]) / ry[1])]; }
      p.frame();
      var dots = points.map(function (q) {
        var a = p.at(at(q[0], q[1]));
        return "M" + a[0].toFixed(1) + " " + a[1].toFixed(1) + "h.9";
      });
      p.add("path", { d: dots.join(""), "class": "specks" });
      list.forEach(function (piece) {
        var r = piece.region, low = at(r[0], r[2]), high = at(r[1], r[3]);
        if (grids) {
          piece.x.forEach(function (x) {
            p.segment(at(x, piece.y[0]), at(x, piece.y[piece.y.length - 1]), "grid");
          });
          piece.y.forEach(function (y) {
            p.segment(at(piece.x[0], y), at(piece.x[piece.x.length - 1], y), "grid");
          });
        }
        p.area(low, high, "ring");
      });
      var count = list.map(function (q) { return q.points; });
      stage.say(N.toLocaleString("en") + " points in " + list.length
        + " pieces of " + Math.min.apply(0, count) + " to "
        + Math.max.apply(0, count) + " points, each with a grid of its own.");
    }

    stage.choice("Points", kinds, function (k) { kind = k; redraw(); });
    stage.choice("Grids", ["not shown", "shown"], function (k) {
      grids = k === 1;
      redraw();
    });
    stage.button("Other points", function () { seed++; redraw(); });
    redraw();

    // No point is lost, and the search through the pieces is right.
    return { check: function () {
      var good = kinds.every(function (name) {
        c.generate(name, N, seed);
        var sum = pieces().reduce(function (s, q) { return s + q.points; }, 0);
        c.generate(name, 1500, seed);
        c.set_geometry(1, 1, 1);
        c.by("adaptive");
        var fast = c.f64(c.nearest2(), 1500).join()
          + c.f64(c.furthest2(), 1500).join();
        c.by("naive");
        return sum === N && fast === c.f64(c.nearest2(), 1500).join()
          + c.f64(c.furthest2(), 1500).join();
      });
      redraw();
      return good;
    } };
  }
});
