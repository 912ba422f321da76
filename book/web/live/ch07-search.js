// A spiral search, cell by cell, for any point that you choose, and how
// many cells the searches of all points visit.
"use strict";

live("ch07-search", {
  title: "follow a spiral search, cell by cell",
  ask: "The search above visits 16 cells. Take 144 other points in 144 cells, "
    + "and search for the neighbor of each. How many cells does a search visit "
    + "on average?",
  choices: ["About 5", "About 9", "About 12", "About 16"],
  because: "It is about 5: in more than half of the searches there is another "
    + "point in the query's own cell, and then D is small. The search "
    + "shown first is the longest.",

  show: function (stage) {
    var N = 144, c = stage.c, points, grid, self = 0, trace = [], all = [];
    var seed = 9;
    var p = draw.plane(stage, "144 points in a grid of cells, and the cells "
      + "that the search of one of them visits. Click, or move the cross "
      + "with the arrow keys and press Enter, to choose the nearest point as "
      + "the query.", function (x, y) {
        choose(draw.nearest(points, x, y));
        return "The query is point " + self + ", at "
          + draw.place(points[self]) + ".";
      });
    var table = live.element("table", { "class": "tally" });
    var list = draw.list(stage, "The points in words");
    stage.box.after(live.element("p", { "class": "hint" }, [
      live.element("span", { "class": "key wash" }), " phase one; ",
      live.element("span", { "class": "key later" }), " phase two; dashed, the "
      + "square of side 2D; the large dot is the query. Click a point to make "
      + "it the query; by keyboard, go to the picture, move the cross with "
      + "the arrow keys (with Shift, in larger steps) and press Enter."]));

    function prepare() {
      points = c.generate("uniform", N, seed);
      c.set_geometry(1, 1, 1);
      c.sort_cells(1);
      grid = { m: c.columns(), x: c.f64(c.column_border(), c.columns() + 1),
        y: c.f64(c.row_border(), c.rows() + 1) };
      all = points.map(function (_, i) { return search(i); });
      list(all.map(function (t, i) {
        return "Point " + i + " at " + draw.place(points[i]) + ": "
          + draw.many(t.length, "cell", "cells");
      }));
      choose(longest());
    }

    function longest() {
      return all.reduce(function (best, t, i) {
        return t.length > all[best].length ? i : best;
      }, 0);
    }

    function choose(i) {
      self = i;
      trace = all[i];
      tally();
      walk.go(0);
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

    function layer(t, v) {
      return Math.max(Math.abs(v.column - t[0].column),
        Math.abs(v.row - t[0].row));
    }

    // Phase one ends with the first layer in which there was a point.
    function phase_one(t) {
      var found = t.find(function (v) { return v.nearest !== null; });
      return t.filter(function (v) {
        return layer(t, v) <= layer(t, found);
      }).length;
    }

    function distance(i, j) {
      return Math.hypot(points[i][0] - points[j][0],
        points[i][1] - points[j][1]);
    }
    function widths(d) { // as the table of the text has them
      return (d / (grid.x[1] - grid.x[0])).toFixed(2);
    }
    // How many searches visit how many cells; a button chooses such a
    // search, and the next one when it is pressed again.
    function tally() {
      var lengths = [], numbers = live.element("tr", {},
        live.element("th", { scope: "row" }, "Cells"));
      var counts = live.element("tr", {},
        live.element("th", { scope: "row" }, "Searches"));
      all.forEach(function (t) {
        lengths[t.length] = lengths[t.length] + 1 || 1;
      });
      lengths.forEach(function (count, length) {
        var b = live.element("button", { type: "button", "aria-label":
          "A search of " + draw.many(length, "cell", "cells"), "aria-pressed":
          String(length === trace.length) }, String(length));
        b.addEventListener("click", function () {
          var of_length = function (_, k) {
            return all[(self + 1 + k) % N].length === length;
          };
          choose((self + 1 + all.findIndex(of_length)) % N);
          table.querySelector("[aria-pressed=true]").focus();
        });
        numbers.append(live.element("td", {}, b));
        counts.append(live.element("td", {}, String(count)));
      });
      table.replaceChildren(numbers, counts);
    }

    function about_all() {
      var sum = 0, own = 0, go_on = 0;
      all.forEach(function (t) {
        sum += t.length;
        if (phase_one(t) > 1) return;
        own++;
        if (t.length > 1) go_on++;
      });
      return "On average a search visits " + (sum / N).toFixed(1)
        + " cells. In " + own + " of " + N + " there is another point in the "
        + "query's own cell; " + go_on + " of these go on to phase two.";
    }

    // Step 0 shows the query; then there is a step for each cell, and one
    // for the square between the phases.
    function show(k) {
      var first = phase_one(trace), square = k > first, sum = 0;
      var q = points[self], visited = square ? k - 1 : k, d = null;
      var now = visited ? trace[visited - 1] : null;
      p.clear();
      trace.slice(0, visited).forEach(function (v, i) {
        sum += v.compared;
        p.area([grid.x[v.column], grid.y[v.row]], [grid.x[v.column + 1],
          grid.y[v.row + 1]], i < first ? "wash" : "later");
      });
      grid.x.forEach(function (x) { p.segment([x, grid.y[0]],
        [x, grid.y[grid.y.length - 1]], "grid"); });
      grid.y.forEach(function (y) { p.segment([grid.x[0], y],
        [grid.x[grid.m], y], "grid"); });
      if (square) {
        d = distance(self, trace[first - 1].nearest);
        p.area([q[0] - d, q[1] - d], [q[0] + d, q[1] + d], "ring");
      }
      if (now && now.nearest !== null) {
        p.segment(q, points[now.nearest], "stroke");
      }
      points.forEach(function (o) { p.dot(o, "dot", 3); });
      p.dot(q, "query", 6);
      trace.slice(0, visited).forEach(function (v, i) {
        var at = p.at([grid.x[v.column], grid.y[v.row + 1]]);
        p.add("text", { x: at[0] + 3, y: at[1] + 13, "class": "visit" }, i + 1);
      });
      p.cross();
      stage.say(k === 0 ? "The search of the large dot, point " + self + ": "
        + draw.many(trace.length, "cell", "cells") + ". Step through it, or choose "
        + "another point. " + about_all()
        : k === first + 1 ? between(first, d)
          : visit(visited, now, visited <= first, sum)
            + (k === trace.length + 1 ? " This is the neighbor." : ""));
    }

    function visit(k, v, in_one, sum) {
      return "Visit " + k + " of " + trace.length + ", layer " + layer(trace, v)
        + ", phase " + (in_one ? "one" : "two") + ": "
        + (v.compared ? draw.many(v.compared, "point", "points") : "no point")
        + " compared there, " + sum + " in all. " + (v.nearest === null
        ? "No candidate yet." : "The best is "
        + widths(distance(self, v.nearest)) + " widths of a cell away.");
    }

    function between(first, d) {
      var more = trace.length - first;
      return "Phase one is over, with D = " + widths(d) + " widths of a cell. "
        + "The square of side 2D meets " + (more ? draw.many(more, "cell", "cells")
        + " more: " + (more === 1 ? "it is" : "they are") + " phase two."
        : "no other cell of the grid: there is nothing left for phase two, "
        + "and this is the neighbor.");
    }

    var walk = draw.steps(stage, function () {
      return trace.length + 1;
    }, show);
    stage.button("Other points", function () { seed++; prepare(); });
    stage.status.after(live.element("p", { "class": "hint" }, "How many of the "
      + "144 searches visit so many cells. Press a number to see such a "
      + "search, and again, where there are several, to see the next."),
      live.element("div", { "class": "table" }, table));
    prepare();

    // Whether the cells are those of both phases: all up to the layer of
    // the first point, and those beyond that the square of side 2D meets.
    function as_told(t, i) {
      var first = phase_one(t), q = points[i], most = layer(t, t[first - 1]);
      var d = distance(i, t[first - 1].nearest), told = 0;
      for (var x = 0; x < grid.m; x++) {
        for (var y = 0; y < grid.y.length - 1; y++) {
          if (layer(t, { column: x, row: y }) <= most
            || (grid.x[x] <= q[0] + d && grid.x[x + 1] >= q[0] - d
            && grid.y[y] <= q[1] + d && grid.y[y + 1] >= q[1] - d)) told++;
        }
      }
      return told === t.length;
    }

    return {
      asked: function () { // what the figure begins with
        return trace.length >= 16 && phase_one(trace) < trace.length;
      },
      check: function () {
        var before = seed, good = true, mean = 0;
        for (seed = 9; seed < 17; seed++) {
          prepare();
          c.by("naive");
          var right = c.u32(c.nearest(), N);
          good = good && all.every(function (t, i) {
            return t[t.length - 1].nearest === right[i] && as_told(t, i);
          });
          all.forEach(function (t) { mean += t.length / N / 8; });
        }
        seed = before;
        prepare();
        return good && mean > 4 && mean < 6.5; // as the figure's answer says
      } };
  }
});
