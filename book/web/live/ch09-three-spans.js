// Eight queries of a row of cells share three spans of candidates.
"use strict";

live("ch09-three-spans", {
  title: "three spans and eight queries",
  ask: "Eight queries share their candidates: three rows of cells. How many "
    + "of the eight will be sure of their answer?",

  show: function (stage) {
    var N = 200, c = stage.c, points, sorted, start, grid, at = 0;
    var p = draw.plane(stage, "200 points in cells; eight queries of a row, "
      + "and the three rows of cells around them.");
    var bar = draw.picture(stage, 460, 46, "The same points in memory, by "
      + "cell: the three rows are three spans.");
    var slide = live.element("input", { type: "range", min: 0, max: N - 1,
      value: 0 });
    stage.panel.append(live.element("label", {}, ["First query, by cell: ",
      slide]));
    slide.addEventListener("input", function () { show(Number(slide.value)); });
    stage.button("Next eight", function () {
      show(at + batch(at).width < N ? at + batch(at).width : 0);
    });

    function prepare(seed) {
      points = c.generate("uniform", N, seed);
      c.set_geometry(1, 1, 1);
      var cells = c.sort_cells(2);
      sorted = Array.from(c.u32(c.point(), N));
      start = c.u32(c.start(), cells + 1);
      grid = { m: c.columns(), x: c.f64(c.column_border(), c.columns() + 1),
        y: c.f64(c.row_border(), c.rows() + 1) };
    }

    // From sorted point s on: its spans, and each query's answer.
    function batch(s) {
      var width = c.batch_from(s), spans = [], answers = [];
      var first = c.block_column(), count = c.block_columns();
      for (var r = 0; r < c.block_rows(); r++) {
        var k = (c.block_row() + r) * grid.m + first;
        spans.push([start[k], start[k + count]]);
      }
      for (var i = s; i < s + width; i++) {
        var found = c.nearest_in_batch(i) >>> 0, margin = c.margin_of_block();
        answers.push({ query: sorted[i], found: found,
          sure: c.block_best2() < margin * margin });
      }
      return { width: width, spans: spans, answers: answers,
        low: [grid.x[first], grid.y[c.block_row()]],
        high: [grid.x[first + count], grid.y[c.block_row() + c.block_rows()]] };
    }

    function show(s) {
      var b = batch(s), X = 440 / N;
      at = s;
      slide.value = s;
      p.frame();
      p.area(b.low, b.high, "wash");
      grid.x.forEach(function (x) { p.segment([x, grid.y[0]],
        [x, grid.y[grid.y.length - 1]], "grid"); });
      grid.y.forEach(function (y) { p.segment([grid.x[0], y],
        [grid.x[grid.m], y], "grid"); });
      points.forEach(function (q) { p.dot(q, "dot", 2.5); });
      b.answers.forEach(function (a) {
        if (a.found < N) p.segment(points[a.query], points[a.found],
          a.sure ? "stroke" : "wrong");
        p.dot(points[a.query], "query", 4.5);
      });
      bar.clear();
      bar.add("rect", { x: 10, y: 8, width: 440, height: 26, "class": "box" });
      b.spans.forEach(function (span) {
        bar.add("rect", { x: 10 + span[0] * X, y: 8, height: 26,
          width: (span[1] - span[0]) * X, "class": "warm" });
      });
      bar.add("rect", { x: 10 + s * X, y: 8, width: b.width * X, height: 26,
        "class": "lit" });
      p.tell(b.answers.map(function (a) {
        return "Query " + a.query + (a.found < N ? ", nearest " + a.found : "")
          + (a.sure ? ": sure." : ": not sure.");
      }).join(" "));
      bar.tell(b.spans.map(function (span) {
        return "Places " + span[0] + " to " + (span[1] - 1) + ".";
      }).join(" "));
      var shared = b.spans.reduce(function (sum, span) {
        return sum + span[1] - span[0];
      }, 0);
      var sure = b.answers.filter(function (a) { return a.sure; }).length;
      stage.say(b.width + " queries share " + shared + " candidates in "
        + b.spans.length + " spans. " + sure + " of them are sure: their "
        + "nearest is nearer than the border of the block. The others, in "
        + "orange, have to look further.");
    }

    prepare(4);
    show(96);
    stage.say(stage.status.textContent + " You said " + stage.predicted + ".");

    return { check: function () {
      c.by("naive");
      var right = c.u32(c.nearest(), N), sure = 0;
      for (var s = 0; s < N;) {
        var b = batch(s);
        if (!b.answers.every(function (a) {
          if (a.sure) sure++;
          return !a.sure || a.found === right[a.query];
        })) return false;
        s += b.width;
      }
      return sure > N / 2;
    } };
  }
});
