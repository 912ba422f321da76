// The program near in the page: points of a generator or of a file, and
// their answers.
"use strict";

live("ch01-near", {
  title: "near, in this page",
  ask: "For both answers, the plain loop compares each of 100,000 points with "
    + "99,999 others. How many distances a point does near's fastest algorithm "
    + "compute?",
  choices: ["About 40", "About 600", "About 9,000", "About 50,000"],
  because: "It is about 40, if the points are uniform, and for a million as "
    + "many as for a thousand. The chapters 4 to 10 say how. Below, near runs "
    + "here, on these points or on yours.",

  show: function (stage) {
    var SHOWN = 8, TRIALS = 5, FEW = 1000;
    var KINDS = ["uniform", "clustered", "circle", "lattice", "kuzmin"];
    var SIZES = [1000, 10000, 100000, 1000000];
    var table = live.element("table", {}), geometry = 1, last = null;
    var kind = 0, size = 2, again = generated; // what was asked for last
    var input = live.element("input", { type: "file" });
    stage.box.append(live.element("div", { "class": "table", tabindex: "0",
      role: "region", "aria-label": "The first answers" }, table));
    stage.box.before(live.element("p", {}, live.element("label", {}, [
      "A file of points (two numbers a line, TSPLIB, or .npy; it stays on "
      + "this machine), chosen here or dropped on the table: ", input])));
    stage.box.addEventListener("dragover", function (event) {
      event.preventDefault();
    });
    stage.box.addEventListener("drop", function (event) {
      event.preventDefault();
      if (event.dataTransfer.files[0]) open(event.dataTransfer.files[0]);
    });
    input.addEventListener("change", function () {
      if (input.files[0]) open(input.files[0]);
    });

    // A file that is refused ends the program: the next gets a fresh one.
    // The reader's words of an option that the page lacks are left out.
    function open(file) {
      return file.arrayBuffer().then(function (buffer) {
        again = function () {
          forget();
          var c = stage.fresh();
          try {
            c.text(new Uint8Array(buffer));
            answer(c, c.read_text(name(c, file.name)), file.name);
          } catch (error) {
            stage.say(error.message.replace(" (or --columns I,J)", ""));
          }
        };
        again();
      });
    }

    // The name must not be where the file is.
    function name(c, words) {
      var bytes = new TextEncoder().encode(words + "\0");
      var at = c.memory.grow(1) * 65536;
      new Uint8Array(c.memory.buffer, at, bytes.length).set(bytes);
      return at;
    }

    function generated() {
      var c = stage.fresh(), n = SIZES[size];
      again = generated;
      input.value = "";
      c.generate_points(c.text(KINDS[kind]), n, 1);
      answer(c, n, "Generator " + KINDS[kind]);
    }

    function forget() { // so that nothing old stands under a new name
      last = null;
      stage.enable(save, false);
      table.replaceChildren();
    }

    // The box that wraps around: the unit square or, if that does not hold
    // all points, the smallest that does.
    function box(c, n) {
      var low = [0, 0], high = [1, 1], all = [c.f64(c.x(), n), c.f64(c.y(), n)];
      function ends(k, from) {
        low[k] = high[k] = from;
        all[k].forEach(function (v) {
          if (v < low[k]) low[k] = v;
          if (v > high[k]) high[k] = v;
        });
      }
      function inside(v) { return v >= 0 && v <= 1; }
      if (!all[0].every(inside) || !all[1].every(inside)) {
        ends(0, all[0][0]);
        ends(1, all[1][0]);
      }
      return { low: low, high: high };
    }

    function short(v) { return String(Number(v.toPrecision(6))); }

    function answer(c, n, from) {
      forget();
      if (n < 2) { stage.say(from + ": one point has no neighbor."); return; }
      var b = box(c, n), times = [], until = performance.now() + 1500;
      c.set_geometry(geometry, b.high[0] - b.low[0], b.high[1] - b.low[1]);
      do { // several times, as once is not enough, but not for ever
        var began = performance.now();
        c.by("by-sample");
        times.push(performance.now() - began);
      } while (times.length < TRIALS && performance.now() < until);
      times.sort(function (s, t) { return s - t; });
      last = { c: c, n: n, took: times[times.length >> 1],
        distances: c.distances() / n };
      stage.enable(save, true);
      show(c, n);
      stage.say(from + ": both answers for " + thousands(n)
        + " points" + (n < FEW ? "" : ", " + last.distances.toFixed(1)
        + " distances a point; the plain loop computes " + thousands(n - 1))
        + ". It took " + time(times[0])
        + (times.length === 1 ? ", once." : " to "
        + time(times[times.length - 1]) + " in " + times.length
        + " trials, with the median " + time(last.took) + ".")
        + (geometry === 1 ? "" : " The box that wraps around is "
        + short(b.low[0]) + ", " + short(b.low[1]) + " to "
        + short(b.high[0]) + ", " + short(b.high[1]) + "."));
    }

    function time(ms) { return ms.toFixed(ms < 10 ? 1 : 0) + " ms"; }

    function rows(n, form) { // of the first n points, or of all
      var c = last.c, x = c.f64(c.x(), n), y = c.f64(c.y(), n);
      var a = c.u32(c.nearest(), n), b = c.f64(c.nearest2(), n);
      var d = c.u32(c.furthest(), n), e = c.f64(c.furthest2(), n);
      return Array.from(x, function (v, i) {
        return [i, form(v), form(y[i]), a[i], form(Math.sqrt(b[i])), d[i],
          form(Math.sqrt(e[i]))];
      });
    }

    function show(c, n) {
      function line(kind, cells) {
        return live.element("tr", {}, cells.map(function (v) {
          return live.element(kind, kind === "th" ? { "class": "right",
            scope: "col" } : { "class": "right" }, String(v));
        }));
      }
      var head = line("th", ["i", "x", "y", "nearest", "distance to it",
        "furthest", "distance to it"]);
      table.replaceChildren(live.element("thead", {}, head),
        live.element("tbody", {}, rows(Math.min(n, SHOWN), short).map(
          function (r) { return line("td", r); }).concat(n > SHOWN
            ? line("td", ["…", "", "", "", "", "", ""]) : [])));
    }

    function thousands(n) { return n.toLocaleString("en"); }

    stage.choice("Generator", KINDS, function (k) { kind = k; generated(); });
    stage.choice("Points", SIZES.map(thousands), function (k) {
      size = k;
      generated();
    }).selectedIndex = size;
    stage.choice("Geometry", ["standard", "wraparound"], function (k) {
      geometry = k + 1;
      again();
    });
    stage.button("Generate, and answer", generated);
    var save = stage.button("Save the answers", function () {
      var text = [["i", "x", "y", "nearest", "nearest_distance", "furthest",
        "furthest_distance"]].concat(rows(last.n, Number));
      var link = live.element("a", { download: "answers.tsv",
        href: URL.createObjectURL(new Blob([text.map(function (r) {
          return r.join("\t") + "\n";
        }).join("")])) });
      link.click();
      URL.revokeObjectURL(link.href);
    });
    generated();

    return {
      open: open,
      took: function () { generated(); return last.took; },
      again: function () { // once more, in memory that has been touched
        var began = performance.now();
        last.c.by("by-sample");
        return performance.now() - began;
      },
      asked: function () { // the number of distances is said
        return /, (3\d|4\d)\.\d distances a point; the plain loop .* 99,999\./
          .test(stage.status.textContent);
      },
      check: function () {
        var good = true;
        [1, 2].forEach(function (geometry) {
          var c = stage.fresh(), n = 2000;
          c.generate("clustered", n, 7);
          var b = box(c, n);
          c.set_geometry(geometry, b.high[0] - b.low[0], b.high[1] - b.low[1]);
          c.by("by-sample");
          var fast = [c.u32(c.nearest(), n), c.u32(c.furthest(), n)].join();
          c.by("naive");
          good = good && c.distances() === n * (n - 1) && fast
            === [c.u32(c.nearest(), n), c.u32(c.furthest(), n)].join();
        });
        return good;
      } };
  }
});
