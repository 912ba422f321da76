// Fool the block of nine cells: put points so that its answer is wrong.
"use strict";

live("ch04-wrong", {
  title: "fool the block of nine cells",
  ask: "Can the nine cells around a query have a point, and the nearest "
    + "point be outside of them?",
  choices: ["No, what is outside is further", "Yes"],
  because: "Yes: a point in a corner of the block can be further than "
    + "one just outside of its side. Put two such points.",

  show: function (stage) {
    var c = stage.c, query = [0.49, 0.5], points = [];
    var p = draw.plane(stage, "A square of 7 by 7 cells, with a query in the "
      + "middle cell. Click to put a point or remove it; or arrow keys and "
      + "Enter.", act);

    function act(x, y) {
      var hit = points.findIndex(function (q) {
        return Math.hypot(q[0] - x, q[1] - y) < 0.02;
      });
      if (hit >= 0) points.splice(hit, 1); else points.push([x, y]);
      redraw();
    }

    // The query, what was put, and the corners, so that the grid stays.
    function all() {
      return [query].concat(points, [[0, 0], [1, 1], [0, 1], [1, 0]]);
    }

    function ask() {
      var list = all(), n = list.length;
      c.points(list);
      c.set_geometry(1, 1, 1);
      c.sort_cells(n / 49);
      var found = c.nearest_in_block(0) >>> 0; // C has no sign
      var best2 = c.block_best2(), margin = c.margin_of_block();
      var border = [c.f64(c.column_border(), c.columns() + 1),
        c.f64(c.row_border(), c.rows() + 1)];
      var first = [c.block_column(), c.block_row()];
      var count = [c.block_columns(), c.block_rows()];
      c.by("naive");
      return { list: list, found: found, right: c.u32(c.nearest(), 1)[0],
        sure: best2 < margin * margin, margin: margin, border: border,
        low: [border[0][first[0]], border[1][first[1]]],
        high: [border[0][first[0] + count[0]], border[1][first[1] + count[1]]] };
    }

    function redraw() {
      var a = ask(), none = a.found === 0xFFFFFFFF;
      p.frame();
      p.area(a.low, a.high, "wash");
      a.border[0].forEach(function (x) { p.segment([x, 0], [x, 1], "grid"); });
      a.border[1].forEach(function (y) { p.segment([0, y], [1, y], "grid"); });
      p.circle(query, a.margin, "ring");
      a.list.forEach(function (q) { p.dot(q, "dot"); });
      p.dot(query, "query", 6);
      if (!none) p.segment(query, a.list[a.found], "stroke");
      if (a.right !== a.found) p.segment(query, a.list[a.right], "wrong");
      p.cross();
      stage.say(none ? "The block has no other point: it must grow."
        : a.right === a.found ? (a.sure ? "The block's answer is right, and "
        + "the test knows: it is nearer than the block's nearest border."
        : "The block's answer is right, but the test cannot know: it is "
        + "beyond the ring.") : "Fooled: the nearest point is outside the "
        + "block. It is nearer than the one inside, which lies beyond the "
        + "ring; so the test will not trust it.");
    }

    stage.button("Fool it", function () {
      points = [[0.3, 0.7], [0.49, 0.725]];
      redraw();
    });
    stage.button("None", function () { points = []; redraw(); });
    redraw();

    // Where the test is sure, the block is right; whatever the points.
    return { check: function () {
      var kept = points, good = true, wrong = 0;
      for (var seed = 1; seed <= 40; seed++) {
        points = c.generate("uniform", 40, seed);
        var a = ask();
        if (a.found !== a.right) wrong++;
        if (a.sure && a.found !== a.right) good = false;
      }
      points = [[0.3, 0.7], [0.49, 0.725]];
      var b = ask();
      points = kept;
      redraw();
      return good && b.found !== b.right && !b.sure;
    } };
  }
});
