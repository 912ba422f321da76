// Crowds, and the pieces that they are cut into.
"use strict";

live("ch11-pieces", {
  title: "crowds, and the partition that adapts",
  ask: "20,000 points are cut where they crowd, until each piece is even enough "
    + "for a grid of its own. Which points end in the most pieces?",
  choices: ["Ten wide clusters, which overlap", "Two small clusters, far apart",
    "A hundred towns, and one point in ten in the country",
    "Kuzmin’s disc, a dense center with far outskirts"],

  show: function (stage) {
    var N = 20000, c = stage.c, seed = 1, kind = stage.predicted, grids = true;
    var kinds = ["clustered", "two-clusters", "towns", "kuzmin", "uniform",
      "spiral", "log-normal", "circle"], offered = 4;
    var names = ["ten clusters", "two far clusters", "a hundred towns",
      "Kuzmin’s disc", "uniform", "spiral", "log-normal", "on a circle"];
    var points, list, view, whole, chosen = null, together;
    var p = draw.plane(stage, "20,000 points, and the regions of the pieces "
      + "that they are cut into.", act, function (q) {
        return draw.place(from(q)); });
    stage.box.append(live.element("p", { "class": "hint" }, "Dashed: the "
      + "regions of the pieces. Thin: the grid of each piece, where its cells "
      + "are large enough to be seen. Shaded: the piece you chose. Click to go "
      + "into the piece at that place, or, in the picture, use the arrow keys "
      + "(with Shift, larger steps) and Enter; then zoom out, step by step. "
      + "Whatever they are, points are first cut into parts of at most 4,096. "
      + "Then a part is cut again if its crowding (with how many points a point "
      + "shares its cell, itself included) is more than 8 and it has 96 points "
      + "or more; what is smaller stays, however it crowds."));
    var words = draw.list(stage, "The largest pieces in words");

    // The crowding: with how many points a point shares its cell.
    function crowding(start) {
      var squares = 0, k = 0;
      for (; k + 1 < start.length; k++) {
        squares += (start[k + 1] - start[k]) * (start[k + 1] - start[k]);
      }
      return squares / (start[k] - start[0]);
    }

    function pieces() {
      var all = [];
      c.cut_pieces();
      for (var leaf = 0; leaf < c.leaves(); leaf++) {
        var first = c.first_piece(leaf);
        for (var k = first; k < first + c.piece_count(leaf); k++) {
          var m = c.piece_columns(k), r = c.piece_rows(k);
          all.push({ region: c.f64(c.piece_region(k), 4),
            points: c.piece_points(k), columns: m, rows: r,
            x: m ? c.f64(c.piece_column_border(k), m + 1) : [],
            y: m ? c.f64(c.piece_row_border(k), r + 1) : [],
            crowding: m ? crowding(c.u32(c.piece_start(k), m * r + 1)) : 0 });
        }
      }
      return all;
    }

    function prepare() {
      points = c.generate(kinds[kind], N, seed);
      c.set_geometry(1, 1, 1);
      var cells = c.sort_cells(1.5);
      together = crowding(c.u32(c.start(), cells + 1));
      list = pieces();
      whole = view = square([0, 1].map(range), 1.08);
      chosen = null;
      redraw();
    }

    // ---- the window ------------------------------------------------------
    // Begins where all but the outermost hundredth of the points are, with
    // a margin, so that nothing is hidden by the frame.
    function range(k) {
      var s = Float64Array.from(points, function (q) { return q[k]; }).sort();
      var low = s[Math.floor(N * 0.005)], high = s[Math.floor(N * 0.995)];
      return { low: low, high: high };
    }

    // A square window around what has these ranges, by a factor larger.
    function square(ranges, factor) {
      var size = factor * Math.max.apply(0, ranges.map(function (r) {
        return r.high - r.low;
      }));
      return ranges.map(function (r) {
        return { low: (r.low + r.high - size) / 2, size: size };
      });
    }

    function to(x, y) {
      return [x, y].map(function (v, k) {
        return Math.min(1, Math.max(0, (v - view[k].low) / view[k].size));
      });
    }

    function from(q) {
      return q.map(function (v, k) { return view[k].low + v * view[k].size; });
    }

    function inside(q) {
      return q.every(function (v, k) {
        return v >= view[k].low && v <= view[k].low + view[k].size;
      });
    }

    function zoom(factor) {
      view = view.map(function (v) {
        return { low: v.low + v.size * (1 - factor) / 2, size: v.size * factor };
      });
      redraw();
    }

    function act(x, y) {
      var at = from([x, y]);
      chosen = list.find(function (q) {
        var r = q.region;
        return at[0] >= r[0] && at[0] < r[1] && at[1] >= r[2] && at[1] < r[3];
      });
      if (chosen.columns) {
        view = square([chosen.x, chosen.y].map(function (b) {
          return { low: b[0], high: b[b.length - 1] };
        }), 1.3);
      }
      redraw();
      return about(chosen);
    }

    function about(q) {
      return q.columns ? "This piece has " + q.points.toLocaleString("en")
        + " points in a grid of " + q.columns + " by " + q.rows + " cells, with "
        + "a crowding of " + q.crowding.toFixed(1) + "." : "This piece has "
        + q.points.toLocaleString("en") + " points, all in one place.";
    }

    // ---- the picture --------------------------------------------------------
    function draw_grid(q) {
      var width = q.x[q.columns] - q.x[0], height = q.y[q.rows] - q.y[0];
      if (width / q.columns / view[0].size * 440 < 4
        || height / q.rows / view[1].size * 440 < 4) return;
      q.x.forEach(function (x) {
        p.segment(to(x, q.y[0]), to(x, q.y[q.rows]), "hair");
      });
      q.y.forEach(function (y) {
        p.segment(to(q.x[0], y), to(q.x[q.columns], y), "hair");
      });
    }

    function meets(q) {
      var r = q.region;
      return r[0] < view[0].low + view[0].size && r[1] > view[0].low
        && r[2] < view[1].low + view[1].size && r[3] > view[1].low;
    }

    function draw_points(size) {
      p.add("path", { d: points.filter(inside).map(function (q) {
        var a = p.at(to(q[0], q[1]));
        return "M" + (a[0] - size / 2).toFixed(2) + " " + a[1].toFixed(2) + "h"
          + size;
      }).join(""), "class": "specks", "style": "stroke-width: " + size });
    }

    function redraw() {
      var seen = list.filter(meets), count = points.filter(inside).length;
      p.frame();
      if (chosen) {
        var r = chosen.region;
        p.area(to(r[0], r[2]), to(r[1], r[3]), "wash");
      }
      if (grids) seen.forEach(function (q) { if (q.columns) draw_grid(q); });
      draw_points(count > 5000 ? 0.9 : count > 600 ? 1.6 : 3);
      seen.forEach(function (q) {
        var r = q.region;
        p.area(to(r[0], r[2]), to(r[1], r[3]), "ring");
      });
      p.cross();
      words(list.slice().sort(function (a, b) { return b.points - a.points; })
        .slice(0, 10).map(about));
      tell(seen.length, count);
    }

    function tell(seen, count) {
      var sizes = list.map(function (q) { return q.points; });
      var mean = list.reduce(function (sum, q) {
        return sum + q.points * q.crowding;
      }, 0) / N;
      stage.say((chosen ? about(chosen) + " " : "") + "In one grid these "
        + "points would have a crowding of " + together.toLocaleString("en",
        { maximumFractionDigits: 1 }) + "; they are cut into " + list.length
        + " pieces of " + Math.min.apply(0, sizes).toLocaleString("en") + " to "
        + Math.max.apply(0, sizes).toLocaleString("en") + " points, and in these "
        + "it is " + mean.toFixed(1) + " on average. The window shows "
        + (seen === 1 ? "one piece" : seen + " pieces") + " and "
        + count.toLocaleString("en") + (count === 1 ? " point" : " points")
        + (view === whole && count < N ? ", all but the outermost." : "."));
    }

    function count_all() {
      return kinds.slice(0, offered).map(function (name) {
        c.generate(name, N, seed);
        return pieces().length;
      });
    }

    stage.choice("Points", names, function (k) { kind = k; prepare(); })
      .selectedIndex = kind;
    stage.choice("Grids", ["shown", "not shown"], function (k) {
      grids = k === 0;
      redraw();
    });
    stage.button("Zoom in", function () { zoom(1 / 3); });
    stage.button("Zoom out", function () { zoom(3); });
    stage.button("All", function () { chosen = null; view = whole; redraw(); });
    stage.button("Other points", function () { seed++; prepare(); });

    var counts = count_all(), most = counts.indexOf(Math.max.apply(0, counts));
    prepare();
    stage.answer.textContent = "You said " + names[stage.predicted]
      + (stage.predicted === most ? ", and so it is. " : ". It is " + names[most]
      + ". ") + "Pieces: " + counts.map(function (n, k) {
        return names[k] + " " + n;
      }).join(", ") + ". Eight parts of at most 4,096 points are the least "
      + "for 20,000, and the ten clusters need no more. Kuzmin’s disc is a crowd "
      + "in a crowd in a crowd. Around a hundred towns there are more borders "
      + "between crowd and country than around two clusters: a part that has "
      + "some of both is cut, until it has fewer than 96 points. Your choice is "
      + "shown.";

    // No point is lost, the search through the pieces is right, and towns
    // have the most pieces, counted by their regions.
    return { counts: counts, asked: function () { // all four can be read
      return counts.every(function (n, k) {
        return stage.answer.textContent.includes(names[k] + " " + n);
      });
    }, check: function () {
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
      prepare();
      return good && most === 2 && list.every(function (q) {
        return q.points === points.filter(function (a) {
          return a[0] >= q.region[0] && a[0] < q.region[1]
            && a[1] >= q.region[2] && a[1] < q.region[3];
        }).length;
      });
    } };
  }
});
