// Count, scan and place, step by step, for numbers of one's own.
"use strict";

live("ch04-count-scan-place", {
  title: "count, scan and place your own eight points",
  ask: "Eight points lie in the cells 2, 0, 3, 2, 0, 2, 1, 3. At which place "
    + "does the last point of cell 2 end up?",
  because: "It is place 5. Go through the steps and see why.",

  show: function (stage) {
    var CELLS = 4, cell = [2, 0, 3, 2, 0, 2, 1, 3], states = [];
    var p = draw.picture(stage, 480, 280, "The cells of eight points, the "
      + "counts and starts of four cells, and the places, at each step.");
    var input = live.element("input", { value: cell.join(" "), size: 17 });
    stage.panel.append(live.element("label", {}, ["Cells (one to eight, each 0 "
      + "to 3): ", input]));
    var walk = draw.steps(stage, function () { return states.length - 1; },
      show);

    // Every state that the three loops go through; the scan is the C's.
    function run() {
      var c = stage.c, count = new Array(CELLS).fill(0);
      var place = cell.map(function () { return null; });
      states = [];
      function keep(said, i, k, at) {
        states.push({ said: said, i: i, k: k, at: at, count: count.slice(),
          place: place.slice() });
      }
      keep("All counts are 0.");
      cell.forEach(function (k, i) {
        count[k]++;
        keep("Count: point " + i + " is in cell " + k + ", which has "
          + count[k] + " now.", i, k);
      });
      var at = c.text(new Uint8Array(new Uint32Array(count).buffer));
      c.scan_counts(at, CELLS);
      count = Array.from(c.u32(at, CELLS));
      keep("Scan: each cell begins where those before it end, at "
        + count.join(", ") + ".");
      cell.forEach(function (k, i) {
        place[count[k]] = i;
        count[k]++;
        keep("Place: point " + i + " of cell " + k + " goes to place "
          + (count[k] - 1) + "; the next of its cell to " + count[k] + ".", i,
          k, count[k] - 1);
      });
      states[states.length - 1].said += " By cell, the points are "
        + place.join(", ") + ".";
    }

    function lit(n, k) {
      return Array.from({ length: n }, function (_, i) {
        return i === k ? "lit" : "";
      });
    }

    function show(step) {
      var s = states[step];
      p.clear();
      draw.boxes(p, 100, 30, cell, { label: "cell of point", indices: true,
        kinds: lit(8, s.i) });
      draw.boxes(p, 100, 110, s.count, { label: step <= 8 ? "count" : "next",
        indices: true, kinds: lit(CELLS, s.k) });
      draw.boxes(p, 100, 200, s.place, { label: "point", indices: true,
        kinds: lit(8, s.at) });
      stage.say("Step " + step + " of " + (states.length - 1) + ". " + s.said);
    }

    input.addEventListener("change", function () {
      var read = input.value.split(/[\s,]+/).filter(Boolean);
      var good = read.length >= 1 && read.length <= 8 && read.every(
        function (k) { return /^[0-3]$/.test(k); });
      input.setAttribute("aria-invalid", String(!good));
      if (!good) {
        stage.say("These are not one to eight cells, each 0, 1, 2 or 3: “"
          + input.value + "”. Shown are still " + cell.join(" ") + ".");
        return;
      }
      cell = read.map(Number);
      run();
      walk.go(0);
    });
    run();
    walk.go(0);

    // The whole sort of the book, of points on a line of four cells.
    return { check: function () {
      var c = stage.c, n = cell.length;
      var points = cell.map(function (k) { return [(k + 0.5) / CELLS, 0.5]; });
      var low = points.length;
      points.push([0, 0.5], [1, 0.5]); // the ends
      c.points(points);
      c.set_geometry(1, 1, 1);
      var cells = c.sort_cells(points.length / CELLS);
      if (cells !== CELLS) return false;
      var sorted = Array.from(c.u32(c.point(), points.length));
      var ours = states[states.length - 1].place;
      return sorted.filter(function (i) { return i < low; }).join()
        === ours.join() && n === ours.length;
    } };
  }
});
