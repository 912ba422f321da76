// The program near in the page: a file of points, and its answers.
"use strict";

live("ch01-near", {
  title: "near, in this page",
  ask: "How many milliseconds do both answers for 100,000 points take here?",

  show: function (stage) {
    var SHOWN = 8, table = live.element("pre", { tabindex: "0",
      "class": "captured" }), geometry = 1, last = null;
    var input = live.element("input", { type: "file" });
    stage.box.append(live.element("label", {}, ["A file of points (two "
      + "numbers a line, TSPLIB, or .npy; it stays on this machine): ", input]),
      table);
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
    function open(file) {
      return file.arrayBuffer().then(function (buffer) {
        var c = stage.fresh();
        try {
          c.text(new Uint8Array(buffer));
          return answer(c, c.read_text(name(c, file.name)), file.name);
        } catch (error) {
          stage.say(error.message);
          table.textContent = "";
        }
      });
    }

    // The name must not be where the file is.
    var names = {};
    function name(c, words) {
      names.bytes = new TextEncoder().encode(words + "\0");
      var at = c.memory.grow(1) * 65536;
      new Uint8Array(c.memory.buffer, at, names.bytes.length).set(names.bytes);
      return at;
    }

    function generated() {
      var c = stage.fresh();
      c.generate_points(c.text("uniform"), 100000, 1);
      answer(c, 100000, "100,000 uniform points");
    }

    function box(c, n) { // just large enough for all, from 0
      var x = c.f64(c.x(), n), y = c.f64(c.y(), n), w = 1, h = 1;
      for (var i = 0; i < n; i++) {
        w = Math.max(w, x[i]);
        h = Math.max(h, y[i]);
      }
      return [w, h];
    }

    function answer(c, n, from) {
      if (n < 2) { stage.say("One point has no neighbor."); return; }
      var size = box(c, n);
      c.set_geometry(geometry, size[0], size[1]);
      var began = performance.now();
      c.by("by-sample");
      var took = performance.now() - began;
      last = { c: c, n: n, took: took };
      var x = c.f64(c.x(), SHOWN < n ? SHOWN : n), lines = [];
      var y = c.f64(c.y(), x.length), a = c.u32(c.nearest(), x.length);
      var b = c.f64(c.nearest2(), x.length), d = c.u32(c.furthest(), x.length);
      var e = c.f64(c.furthest2(), x.length);
      x.forEach(function (v, i) {
        lines.push([i, v, y[i], a[i], Math.sqrt(b[i]), d[i],
          Math.sqrt(e[i])].join("  "));
      });
      table.textContent = "i  x  y  nearest  distance  furthest  distance\n"
        + lines.join("\n") + (n > SHOWN ? "\n..." : "");
      stage.say(from + ": both answers for " + n.toLocaleString("en")
        + " points in " + took.toFixed(0) + " ms; you said "
        + stage.predicted + ".");
    }

    stage.choice("Geometry", ["standard", "wraparound"], function (k) {
      geometry = k + 1;
    });
    stage.button("100,000 uniform points", generated);
    stage.button("Save the answers", function () {
      if (!last) return;
      var c = last.c, n = last.n, x = c.f64(c.x(), n), y = c.f64(c.y(), n);
      var a = c.u32(c.nearest(), n), b = c.f64(c.nearest2(), n);
      var d = c.u32(c.furthest(), n), e = c.f64(c.furthest2(), n);
      var text = ["i\tx\ty\tnearest\tnearest_distance\tfurthest\t"
        + "furthest_distance"];
      for (var i = 0; i < n; i++) {
        text.push([i, x[i], y[i], a[i], Math.sqrt(b[i]), d[i],
          Math.sqrt(e[i])].join("\t"));
      }
      var link = live.element("a", { download: "answers.tsv",
        href: URL.createObjectURL(new Blob([text.join("\n") + "\n"])) });
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
      check: function () {
        var c = stage.fresh(), n = 2000;
        c.generate("clustered", n, 7);
        c.set_geometry(1, 1, 1);
        c.by("by-sample");
        var fast = [c.u32(c.nearest(), n), c.u32(c.furthest(), n)].join();
        c.by("naive");
        return fast === [c.u32(c.nearest(), n), c.u32(c.furthest(), n)].join();
      } };
  }
});
