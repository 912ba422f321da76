// Pack by a scan: mark numbers, and see where each of them goes.
"use strict";

live("ch06-pack", {
  title: "mark numbers, and pack them",
  ask: "Ten numbers have the marks 0 1 1 0 0 1 0 1 1 0. To which place does "
    + "the one with the fourth mark go?",
  because: "Place 3: three marks come before the fourth. The scan of the "
    + "marks says so for every number.",

  show: function (stage) {
    var c = stage.c, from = [31, 41, 59, 26, 53, 58, 97, 93, 23, 84];
    var keep = [0, 1, 1, 0, 0, 1, 0, 1, 1, 0], n = from.length;
    var p = draw.picture(stage, 480, 300, "Ten numbers, their marks, the scan "
      + "of the marks, and the packed numbers.");
    var marks = live.element("div", { "class": "panel", role: "group",
      "aria-label": "Marks" });
    stage.panel.before(marks);
    from.forEach(function (v, i) {
      var b = live.element("button", { type: "button", "aria-pressed":
        String(!!keep[i]) }, String(v));
      b.addEventListener("click", function () {
        keep[i] = 1 - keep[i];
        b.setAttribute("aria-pressed", String(!!keep[i]));
        walk.go(0);
      });
      marks.append(b);
    });

    // In C's memory: the numbers, the marks twice, and room for results.
    function packed(numbers, marked) {
      var at = c.room(4 * 5 * (numbers.length + 16)), m = c.memory.buffer;
      var step = 4 * (numbers.length + 16);
      new Uint32Array(m, at, numbers.length).set(numbers);
      new Uint32Array(m, at + step, numbers.length).set(marked);
      new Uint8Array(m, at + 2 * step, numbers.length).set(marked);
      var sum = c.scan(at + 3 * step, at + step, numbers.length);
      var count = c.pack(at + 4 * step, at, at + 2 * step, numbers.length);
      return { sum: sum, count: count,
        place: Array.from(c.u32(at + 3 * step, numbers.length)),
        to: Array.from(c.u32(at + 4 * step, count)) };
    }

    function show(k) {
      var r = packed(from, keep), to = new Array(n).fill(null), X = 120;
      p.clear();
      for (var i = 0; i < k; i++) if (keep[i]) to[r.place[i]] = from[i];
      function lit(j) {
        return from.map(function (_, i) { return i === j ? "lit" : ""; });
      }
      draw.boxes(p, X, 30, from, { label: "from", indices: true,
        kinds: lit(k - 1) });
      draw.boxes(p, X, 85, keep, { label: "keep", kinds: lit(k - 1) });
      draw.boxes(p, X, 140, r.place, { label: "scan of keep",
        kinds: lit(k - 1) });
      draw.boxes(p, X, 230, to, { label: "to", indices: true,
        kinds: lit(k && keep[k - 1] ? r.place[k - 1] : -1) });
      if (k && keep[k - 1]) {
        p.line([X + (k - 0.5) * draw.BOX, 174],
          [X + (r.place[k - 1] + 0.5) * draw.BOX, 228], "stroke");
      }
      stage.say(k === 0 ? "The scan tells for each number how many before it "
        + "are marked. Step through the numbers." : from[k - 1] + (keep[k - 1]
        ? " is marked, and " + r.place[k - 1] + " marked ones come before it: "
        + "it goes to place " + r.place[k - 1] + "." : " is not marked.")
        + (k === n ? " " + r.count + " are kept." : ""));
    }

    var walk = draw.steps(stage, function () { return n; }, show);
    walk.go(0);

    return { check: function () {
      for (var seed = 1; seed < 60; seed++) {
        var list = [], marked = [], x = seed;
        for (var i = 0; i < seed; i++) {
          x = (x * 16807) % 2147483647;
          list.push(x % 1000);
          marked.push(x >> 4 & 1);
        }
        var r = packed(list, marked), plain = list.filter(function (_, i) {
          return marked[i];
        });
        if (r.to.join() !== plain.join() || r.sum !== plain.length) return false;
      }
      return true;
    } };
  }
});
