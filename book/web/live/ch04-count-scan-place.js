// Count, scan and place, step by step, for numbers of one's own, and with
// the points read in either order.
"use strict";

live("ch04-count-scan-place", {
  title: "count, scan and place your own eight points",
  ask: "The points 0, 3 and 5 are in cell 2, and stand there in this order. "
    + "If the last of the three loops reads the points from right to left, "
    + "and nothing else changes, how do they stand?",
  choices: ["0, 3, 5, as before", "5, 3, 0", "One is overwritten by another"],
  because: "They stand as 5, 3, 0. Each cell is still filled from its first "
    + "place on, in the order in which its points are read. So the sort is "
    + "stable only from left to right. Step through it, in both directions.",

  show: function (stage) {
    var MOST = 8, CELLS = 4, cell = [2, 0, 3, 2, 0, 2, 1, 3], states = [];
    var leftward = true;
    var p = draw.picture(stage, 480, 290, "The cells of eight points, the "
      + "counts and starts of four cells, and the places, at each step.");
    var input = live.element("input", { value: cell.join(" "), size: 17 });
    stage.box.after(live.element("p", { "class": "hint" }, [
      live.element("span", { "class": "key lit" }), " what the step reads and "
      + "writes. Thick lines in the lowest row are the borders of the cells, "
      + "as the scan has found them. Other cells: type up to eight numbers "
      + "from 0 to 3."]));
    stage.panel.append(live.element("label", {}, ["Cells of the points: ",
      input]));
    stage.choice("Place reads from", ["right to left", "left to right"],
      function (k) { leftward = k === 0; run(); walk.go(0); });
    var walk = draw.steps(stage, function () { return states.length - 1; },
      show);

    // Every state that the three loops go through; the sums of the scan
    // are the C's.
    function run() {
      var c = stage.c, next = new Array(CELLS).fill(0), sums = null;
      var place = cell.map(function () { return null; });
      states = [];
      function keep(said, i, k, at) {
        states.push({ said: said, i: i, k: k, at: at, next: next.slice(),
          place: place.slice(), name: sums ? "next" : "count",
          borders: sums && k === undefined || place.some(function (q) {
            return q !== null;
          }) ? sums : [] });
      }
      keep("All counts are 0.");
      cell.forEach(function (k, i) {
        next[k]++;
        keep("Count: point " + i + " is in cell " + k + ", which has "
          + draw.many(next[k], "point", "points") + " now.", i, k);
      });
      var counts = next.slice();
      var at = c.text(new Uint8Array(new Uint32Array(counts).buffer));
      c.scan_counts(at, CELLS);
      sums = Array.from(c.u32(at, CELLS));
      sums.forEach(function (sum, k) {
        next[k] = sum;
        keep("Scan: " + (k === 0 ? "cell 0 begins at 0." : "cell " + (k - 1)
          + " begins at " + sums[k - 1] + " and has " + draw.many(counts[k - 1],
          "point", "points") + ", so cell " + k + " begins at " + sums[k - 1]
          + " + " + counts[k - 1] + " = " + sum + "."), undefined, k);
      });
      var order = cell.map(function (_, i) { return i; });
      if (leftward) order.reverse();
      order.forEach(function (i) {
        var k = cell[i];
        place[next[k]] = i;
        next[k]++;
        keep("Place: point " + i + " is in cell " + k + ", whose next place is "
          + (next[k] - 1) + ". It goes there, and the next place of cell " + k
          + " becomes " + next[k] + ".", i, k, next[k] - 1);
      });
    }

    function lit(n, k) {
      return Array.from({ length: n }, function (_, i) {
        return i === k ? "lit" : "";
      });
    }

    function show(step) {
      var s = states[step], n = cell.length, X = 130, Y = 215;
      p.clear();
      draw.boxes(p, X, 30, cell, { label: "cell of point", indices: true,
        kinds: lit(n, s.i) });
      draw.boxes(p, X, 120, s.next, { label: s.name + " of cell",
        indices: true, kinds: lit(CELLS, s.k) });
      draw.boxes(p, X, Y, s.place, { label: "point at place", indices: true,
        kinds: lit(n, s.at) });
      s.borders.concat(s.borders.length ? n : []).forEach(function (b) {
        p.line([X + b * draw.BOX, Y - 2], [X + b * draw.BOX, Y + draw.BOX + 2],
          "border");
      });
      stage.say("Step " + step + " of " + (states.length - 1) + ". " + s.said);
    }

    // What is no number from 0 to 3 is not guessed at.
    input.addEventListener("change", function () {
      var words = input.value.split(/[\s,;]+/).filter(Boolean);
      var good = words.length > 0 && words.length <= MOST
        && words.every(function (w) { return /^[0-3]$/.test(w); });
      input.setAttribute("aria-invalid", String(!good));
      if (!good) {
        stage.say("“" + input.value.trim() + "” will not do: one to eight "
          + "numbers are needed, each 0, 1, 2 or 3, with spaces between them. "
          + "The figure still has " + cell.join(" ") + ".");
        return;
      }
      cell = words.map(Number);
      input.value = cell.join(" ");
      run();
      walk.go(0);
    });
    run();
    walk.go(0);

    // The whole sort of the book, of points on a line of four cells; in
    // the other direction the points of each cell are turned around.
    function in_both_directions() {
      var c = stage.c, n = cell.length, before = leftward;
      var points = cell.map(function (k) { return [(k + 0.5) / CELLS, 0.5]; });
      points.push([0, 0.5], [1, 0.5]); // the ends
      c.points(points);
      c.set_geometry(1, 1, 1);
      if (c.sort_cells(points.length / CELLS) !== CELLS) return false;
      var sorted = Array.from(c.u32(c.point(), points.length))
        .filter(function (i) { return i < n; });
      var good = [false, true].every(function (direction) {
        leftward = direction;
        run();
        var turned = [0, 1, 2, 3].flatMap(function (k) {
          var own = sorted.filter(function (i) { return cell[i] === k; });
          return direction ? own.reverse() : own;
        });
        return states.length === 1 + 2 * n + CELLS
          && states[states.length - 1].place.join() === turned.join();
      });
      leftward = before;
      run();
      return good;
    }

    return {
      asked: function () { // cell 2, read from right to left
        return leftward
          && states[states.length - 1].place.slice(3, 6).join() === "5,3,0";
      },
      check: in_both_directions };
  }
});
