// The row spans of a query, or of eight, and who cannot be sure of what
// is found in them.
"use strict";

live("ch09-three-spans", {
  title: "three spans of any query, and who can be sure",
  ask: "200 uniform points, one in a cell on average. Each looks for its "
    + "nearest in its three row spans and nowhere else. How many of the 200 "
    + "cannot be sure, because what they find, if anything, is further away "
    + "than the border of the block?",

  show: function (stage) {
    var N = 200, c = stage.c, kinds = ["uniform", "clustered", "kuzmin"];
    var names = ["uniform", "ten clusters", "Kuzmin’s disc"];
    var fills = [0.5, 1, 2, 4], widths = [1, 8], rows = ["wash", "warm", "later"];
    var kind = 0, fill = 1, wide = 0, seed = 1, at = 0;
    var points, sorted, place, start, grid, right2, batches;
    var p = draw.plane(stage, N + " points in a grid of cells, the block of "
      + "the query in three colors, and a line to what it finds.",
      function (x, y) { return show(place[draw.nearest(points, x, y)]); });
    var bar = draw.picture(stage, 460, 74, "The sorted points in memory: the "
      + "rows of the block are spans of them.");
    var spans = live.element("p", { "class": "hint" });
    stage.box.append(spans, live.element("p", { "class": "hint" },
      "The large dot is the query, the line leads to the nearest point in the "
      + "spans. Solid: sure. Dashed: not sure, for the circle that ends at the "
      + "border of the block does not reach the point; a thin line then leads "
      + "to a nearer one outside, if there is one. Click a point to make it "
      + "the query; queries are put together later in this "
      + "chapter. By keyboard: the slider, or in the picture the arrow keys "
      + "(with Shift, larger steps) and Enter."));
    var list = draw.list(stage, "The answers in words");

    var value = live.element("output");
    var slide = live.element("input", { type: "range", min: 0, max: N - 1 });
    stage.panel.append(live.element("label", {},
      ["Query, by its place among the sorted points: ", slide, " ", value]));
    slide.addEventListener("input", function () { show(Number(slide.value)); });
    stage.button("Next", function () {
      show((at + batch(at).width) % N);
    });
    stage.button("Next that is not sure", function () {
      var unsure = batches.filter(function (b) { return b.unsure > 0; });
      var next = unsure.find(function (b) { return b.begin > at; });
      if (unsure.length) show((next || unsure[0]).begin);
      else stage.say("All " + N + " are sure here. Try fewer points in a cell.");
    });
    stage.choice("Queries together", ["one", "up to eight, of a row"],
      function (k) { wide = k; prepare(); });
    stage.choice("Points in a cell", ["1/2", "1", "2", "4"], function (k) {
      fill = k;
      prepare();
    }).selectedIndex = fill;
    stage.choice("Points", names, function (k) { kind = k; prepare(); });
    stage.button("Other points", function () { seed++; prepare(); });

    // The grid fills the picture.
    function prepare() {
      c.generate(kinds[kind], N, seed);
      c.set_geometry(1, 1, 1);
      var cells = c.sort_cells(fills[fill]);
      sorted = Array.from(c.u32(c.point(), N));
      place = [];
      sorted.forEach(function (i, s) { place[i] = s; });
      start = c.u32(c.start(), cells + 1);
      grid = { m: c.columns(), x: c.f64(c.column_border(), c.columns() + 1),
        y: c.f64(c.row_border(), c.rows() + 1) };
      var x = c.f64(c.x(), N), y = c.f64(c.y(), N);
      points = Array.from(x, function (v, i) { return to(v, y[i]); });
      c.by("naive");
      right2 = c.f64(c.nearest2(), N);
      batches = [];
      for (var s = 0; s < N; s += batches[batches.length - 1].width) {
        batches.push(batch(s));
      }
      list([].concat.apply([], batches.map(function (b) {
        return b.answers.map(function (a, k) {
          return "Place " + (b.begin + k) + ": point " + a.query + (a.found < N
            ? ", finds " + a.found : ", finds none") + (a.sure ? ", sure"
            : ", not sure") + (a.right ? "" : ", and wrong");
        });
      })));
      show((batches.find(function (b) { return b.unsure; })
        || batches[0]).begin);
    }

    function size() {
      return Math.max(grid.x[grid.m] - grid.x[0],
        grid.y[grid.y.length - 1] - grid.y[0]);
    }

    function to(x, y) {
      return [(x - grid.x[0]) / size(), (y - grid.y[0]) / size()];
    }

    // From sorted point s on: its spans, and each query's answer.
    function batch(s) {
      var width = c.batch_from(s, widths[wide]), three = [], answers = [];
      var first = c.block_column(), count = c.block_columns();
      for (var r = c.block_row(); r < c.block_row() + c.block_rows(); r++) {
        var k = r * grid.m + first;
        three.push({ row: r, first: k, end: k + count, from: start[k],
          to: start[k + count], low: to(grid.x[first], grid.y[r]),
          high: to(grid.x[first + count], grid.y[r + 1]) });
      }
      for (var i = s; i < s + width; i++) {
        var found = c.nearest_in_batch(i) >>> 0, best2 = c.block_best2();
        var margin = c.margin_of_block();
        answers.push({ query: sorted[i], found: found, margin: margin / size(),
          sure: best2 < margin * margin, right: best2 === right2[sorted[i]] });
      }
      return { begin: s, width: width, spans: three, answers: answers,
        shared: three.reduce(function (n, q) { return n + q.to - q.from; }, 0),
        unsure: answers.filter(function (a) { return !a.sure; }).length };
    }

    // A line that ends in a point of its own.
    function arrow(a, b, kind) {
      var u = p.at(a), v = p.at(b), d = Math.hypot(v[0] - u[0], v[1] - u[1]);
      var x = (v[0] - u[0]) / d * 7, y = (v[1] - u[1]) / d * 7;
      p.segment(a, b, kind);
      p.add("path", { d: "M" + (v[0] - x - y / 2) + " " + (v[1] - y + x / 2)
        + "L" + v[0] + " " + v[1] + "L" + (v[0] - x + y / 2) + " "
        + (v[1] - y - x / 2), "class": "tip " + kind });
    }

    function nearest_outside(i) {
      return points.reduce(function (best, q, j) {
        var d = Math.hypot(q[0] - points[i][0], q[1] - points[i][1]);
        return j !== i && d < best.d ? { d: d, j: j } : best;
      }, { d: Infinity, j: i }).j;
    }

    function draw_plane(b) {
      var end = to(grid.x[grid.m], grid.y[grid.y.length - 1]);
      p.clear();
      b.spans.forEach(function (q, r) { p.area(q.low, q.high, rows[r]); });
      grid.x.forEach(function (x) {
        p.segment([to(x, 0)[0], 0], [to(x, 0)[0], end[1]], "grid");
      });
      grid.y.forEach(function (y) {
        p.segment([0, to(0, y)[1]], [end[0], to(0, y)[1]], "grid");
      });
      points.forEach(function (q) { p.dot(q, "dot", 2.5); });
      b.answers.forEach(function (a) {
        var q = points[a.query];
        if ((!a.sure || b.width === 1) && isFinite(a.margin)) {
          p.circle(q, a.margin, "ring");
        }
        if (!a.right) p.segment(q, points[nearest_outside(a.query)], "hair");
        if (a.found < N) {
          arrow(q, points[a.found], a.sure ? "stroke" : "wrong");
        }
        p.dot(q, "query", 4.5);
      });
      p.cross();
    }

    function draw_bar(b) {
      var X = 440 / N;
      bar.clear();
      b.spans.forEach(function (q, r) {
        bar.add("rect", { x: 10 + q.from * X, y: 8, height: 38,
          width: (q.to - q.from) * X, "class": "span " + rows[r] });
      });
      bar.add("rect", { x: 10 + b.begin * X, y: 8, width: b.width * X,
        height: 38, "class": "query" });
      for (var k = 0; k < start.length; k += grid.m) {
        bar.line([10 + start[k] * X, 4], [10 + start[k] * X, 50], "grid");
      }
      bar.add("rect", { x: 10, y: 8, width: 440, height: 38, "class": "box" });
      [0, 50, 100, 150, N].forEach(function (n) {
        bar.add("text", { x: 10 + n * X, y: 66, "class": "index" }, n);
      });
    }

    function list_spans(b) {
      spans.replaceChildren("The " + N + " points as they are sorted, a stroke "
        + "where a row of the grid begins; the "
        + (b.width === 1 ? "query has its place" : "queries have their places")
        + " in color, too.");
      b.spans.forEach(function (q, r) {
        spans.append(live.element("br"),
          live.element("span", { "class": "key " + rows[r] }), " row " + q.row
          + ", from start[" + q.first + "] = " + q.from + " to before start["
          + q.end + "] = " + q.to + ": " + draw.many(q.to - q.from, "point"));
      });
    }

    function one(b) {
      var a = b.answers[0];
      return "The query is compared with the points of "
        + draw.many(b.spans.length, "span") + ", " + draw.many(b.shared, "point")
        + ", itself included. " + (a.sure ? "It is sure." : a.found >= N
        ? "It finds none." : "It is not sure" + (a.right
        ? ", although what it finds is its nearest." : ", and a nearer point is "
        + "outside of the block."));
    }

    function several(b) {
      return (b.width > 1 ? b.width + " queries share " : "One query has ")
        + draw.many(b.shared, "candidate") + " in "
        + draw.many(b.spans.length, "span") + (b.width < 8
        ? " (fewer than eight: here a row ends)" : "") + "; "
        + (b.unsure ? b.unsure + (b.unsure === 1 ? " is" : " are") + " not sure."
        : b.width > 1 ? "all are sure." : "it is sure.");
    }

    function unsure() {
      return batches.reduce(function (n, b) { return n + b.unsure; }, 0);
    }

    function show(s) {
      var b = batch(s), compared = batches.reduce(function (n, q) {
        return n + q.width * q.shared;
      }, 0) / N;
      at = s;
      slide.value = s;
      value.textContent = s + (b.width > 1 ? " to " + (s + b.width - 1) : "")
        + " of 0 to " + (N - 1);
      draw_plane(b);
      draw_bar(b);
      list_spans(b);
      var text = wide ? several(b) : one(b);
      stage.say(text + (unsure() ? " Of all " + N + ", " + unsure()
        + " cannot be sure" : " All " + N + " are sure")
        + "; on average one is compared with " + compared.toFixed(1)
        + " points.");
      return "Query at place " + s + ". " + text;
    }

    prepare();
    stage.answer.textContent = "You said " + stage.predicted
      + (unsure() === stage.predicted ? ", and so it is." : ". It is "
      + unsure() + " of " + N + ".") + " One of them is shown.";

    // Who is sure is right; the example has some that are not, of which
    // one is wrong; with four in a cell there is none.
    return { asked: function () { // one that is not sure is shown
      return !batch(at).answers[0].sure && /not sure/.test(
        stage.status.textContent);
    }, check: function () {
      var good = true, wrong = 0, counts = [];
      for (kind = 0; kind < kinds.length; kind++) {
        for (wide = 0; wide < 2; wide++) {
          for (fill = 0; fill < fills.length; fill++) {
            prepare();
            counts.push(unsure());
            batches.forEach(function (b) {
              b.answers.forEach(function (a) {
                if (a.sure && !a.right) good = false;
                if (!a.right) wrong++;
              });
            });
          }
        }
      }
      kind = wide = 0;
      fill = 1;
      prepare();
      return good && wrong > 0 && counts[1] > 0 && counts[3] === 0
        && unsure() === by_hand();
    } };

    // The same count without the C: whose nearest of the nine cells is
    // no nearer than the border that others lie beyond.
    function by_hand() {
      var x = Array.from(grid.x), y = Array.from(grid.y);
      function cell(borders, v) {
        return Math.min(borders.length - 2, borders.findIndex(function (_, k) {
          return v < borders[k + 1];
        }) >>> 0);
      }
      var px = c.f64(c.x(), N), py = c.f64(c.y(), N), count = 0;
      for (var i = 0; i < N; i++) {
        var k = cell(x, px[i]), r = cell(y, py[i]), best = Infinity;
        for (var j = 0; j < N; j++) {
          if (j !== i && Math.abs(cell(x, px[j]) - k) < 2
            && Math.abs(cell(y, py[j]) - r) < 2) {
            best = Math.min(best, Math.hypot(px[j] - px[i], py[j] - py[i]));
          }
        }
        var margin = Math.min(k > 1 ? px[i] - x[k - 1] : Infinity,
          k + 2 < x.length - 1 ? x[k + 2] - px[i] : Infinity,
          r > 1 ? py[i] - y[r - 1] : Infinity,
          r + 2 < y.length - 1 ? y[r + 2] - py[i] : Infinity);
        if (best >= margin) count++;
      }
      return count;
    }
  }
});
