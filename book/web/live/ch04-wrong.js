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
    var SIDE = 7, c = stage.c, query = [0.49, 0.5], points = [];
    var p = draw.plane(stage, "A square of 7 by 7 cells, columns and rows 0 to "
      + "6 from the lower left corner, with a query in column 3, row 3. Its "
      + "block is the columns and rows 2 to 4. Click to put a point or "
      + "remove it; or move a cross with the arrow keys, further with Shift, "
      + "and press Enter.", act, where);
    var list = draw.list(stage, "The points in words");

    function hit(q) {
      return points.findIndex(function (r) {
        return Math.hypot(r[0] - q[0], r[1] - q[1]) < 0.02;
      });
    }

    function where(q) {
      var cell = q.map(function (v) {
        return Math.min(SIDE - 1, Math.floor(v * SIDE));
      });
      var inside = cell.every(function (k) { return k >= 2 && k <= 4; });
      return draw.place(q) + ", column " + cell[0] + ", row " + cell[1]
        + (inside ? ", in the block, " : ", outside of the block, ")
        + widths(q) + " from the query" + (hit(q) < 0 ? "" : ", where point "
        + (hit(q) + 1) + " is");
    }

    function widths(q) { // how far from the query
      return (SIDE * Math.hypot(q[0] - query[0], q[1] - query[1])).toFixed(2)
        + " cell widths";
    }

    function act(x, y) {
      var i = hit([x, y]), words = i >= 0 ? "Point " + (i + 1) + " removed."
        : "Point " + (points.length + 1) + " put at " + where([x, y]) + ".";
      if (i >= 0) points.splice(i, 1); else points.push([x, y]);
      redraw();
      return words;
    }

    // The query, what was put, and the corners, so that the grid stays.
    function all() {
      return [query].concat(points, [[0, 0], [1, 1], [0, 1], [1, 0]]);
    }

    function ask() {
      var list = all(), n = list.length;
      c.points(list);
      c.set_geometry(1, 1, 1);
      c.sort_cells(n / (SIDE * SIDE));
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

    function verdict(a) {
      function name(i) {
        return i > points.length ? "the point of a corner" : "point " + i;
      }
      if (a.found === 0xFFFFFFFF) {
        return "The block has no other point: it must grow.";
      }
      var answer = name(a.found) + ", " + widths(a.list[a.found]) + " away";
      var ring = "the block's nearest border, which the dashed ring touches, is "
        + (SIDE * a.margin).toFixed(2) + " away";
      if (a.right === a.found) {
        return "The block's answer, " + answer + ", is right, " + (a.sure
          ? "and the test knows: " + ring + ", further than that."
          : "but the test cannot know: " + ring + ", nearer than that.");
      }
      return "Fooled: the nearest is " + name(a.right) + ", "
        + widths(a.list[a.right]) + " away, outside of the block. The block's "
        + "answer is " + answer + ". But " + ring + ", nearer than that; so the "
        + "test will not trust it.";
    }

    function listed() {
      return [query].concat(points).map(function (q, i) {
        return i === 0 ? "The query at " + draw.place(q) + ", column 3, row 3"
          : "Point " + i + " at " + where(q).replace(/, where.*/, "");
      }).concat("A point in each corner of the square, so that the grid stays");
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
      list(listed());
      stage.say(verdict(a));
    }

    stage.button("Fool it", function () {
      points = [[0.3, 0.7], [0.49, 0.73]];
      redraw();
      stage.tell(listed().slice(1, 3).join(". ") + ".");
    });
    stage.button("None", function () {
      points = [];
      redraw();
      stage.tell("No point is put.");
    });
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
      points = [[0.3, 0.7], [0.49, 0.73]];
      var b = ask();
      points = kept;
      redraw();
      return good && b.found !== b.right && !b.sure;
    } };
  }
});
