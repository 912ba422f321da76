// Pack by a scan: mark numbers, and see where each of them goes, and how
// far a mark reaches.
"use strict";

live("ch06-pack", {
  title: "mark numbers, and pack them",
  ask: "The numbers 31 41 59 26 53 58 97 93 23 84 have the marks 0 1 1 0 0 1 "
    + "0 1 1 0, so five of them are kept. Now 26 is marked, too. How many of "
    + "the five go to another place than before?",

  show: function (stage) {
    var c = stage.c, from = [31, 41, 59, 26, 53, 58, 97, 93, 23, 84];
    var keep = [0, 1, 1, 0, 0, 1, 0, 1, 1, 0], n = from.length, X = 130;
    var p = draw.picture(stage, 480, 330, "Ten numbers, their marks, the scan "
      + "of the marks, and the packed numbers.");
    var marks = live.element("div", { "class": "panel", role: "group",
      "aria-label": "Marks" }, "Mark or unmark: ");
    stage.panel.before(live.element("p", { "class": "hint" }, [
      live.element("span", { "class": "key lit" }), " what the step reads and "
      + "writes, or what has changed with a mark. Press a number below, or "
      + "click it in the picture, to mark or unmark it."]), marks);
    var buttons = from.map(function (v, i) {
      var b = live.element("button", { type: "button" }, String(v));
      b.addEventListener("click", function () { mark(i); });
      marks.append(b);
      return b;
    });
    p.svg.style.cursor = "pointer";
    p.svg.addEventListener("click", function (event) {
      var at = new DOMPoint(event.clientX, event.clientY).matrixTransform(
        p.svg.getScreenCTM().inverse());
      var i = Math.floor((at.x - X) / draw.BOX);
      if (i >= 0 && i < n && at.y < 125) mark(i);
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

    function marked(k, one) {
      return k + " marked " + (k === 1 ? "number " + (one || "stands")
        : "numbers stand");
    }

    // A new mark, or one less: what was kept and goes elsewhere now.
    function changed(i) {
      var before, after = packed(from, keep), old = keep.slice();
      old[i] = 1 - old[i];
      before = packed(from, old);
      return { place: after.place.map(function (v, j) {
        return v !== before.place[j];
      }), moved: from.filter(function (_, j) {
        return keep[j] && old[j] && after.place[j] !== before.place[j];
      }) };
    }

    function mark(i) {
      keep[i] = 1 - keep[i];
      walk.go(2 * n);
      after_mark(i);
    }

    function after_mark(i) {
      var d = changed(i), step = keep[i] ? "up" : "down";
      picture(2 * n, function (row, j) {
        return row === "keep" ? j === i : row === "scan" ? d.place[j]
          : row === "to" && d.moved.includes(j);
      });
      stage.say(from[i] + " is " + (keep[i] ? "marked" : "not marked")
        + " now. " + (d.moved.length ? d.moved.length + " of the other numbers "
        + "that are kept " + (d.moved.length === 1 ? "goes" : "go")
        + " one place " + step + ": " + d.moved.join(", ") + "." : "No other "
        + "number that is kept goes to another place.")
        + " Go back step by step to see why.");
    }

    // After k steps: the sums of the scan come first, then the numbers go
    // to their places. lit(row, index, or number) says what is colored.
    function picture(k, lit) {
      var r = packed(from, keep), to = new Array(n).fill(null);
      var scanned = Math.min(k, n), sent = k - scanned;
      function kinds(row, values) {
        return from.map(function (_, j) {
          return lit(row, row === "to" ? values[j] : j) ? "lit" : "";
        });
      }
      p.clear();
      for (var i = 0; i < sent; i++) if (keep[i]) to[r.place[i]] = from[i];
      draw.boxes(p, X, 30, from, { label: "from", indices: true,
        kinds: kinds("from") });
      draw.boxes(p, X, 85, keep, { label: "keep", kinds: kinds("keep") });
      draw.boxes(p, X, 140, r.place.map(function (v, j) {
        return j < scanned ? v : null;
      }), { label: "scan of keep", kinds: kinds("scan") });
      draw.boxes(p, X, 240, to, { label: "to", kinds: kinds("to", to) });
      from.forEach(function (_, j) { // below, where no line goes through
        p.add("text", { x: X + (j + 0.5) * draw.BOX, y: 240 + draw.BOX + 15,
          "class": "index" }, j);
      });
      buttons.forEach(function (b, j) {
        b.setAttribute("aria-pressed", String(!!keep[j]));
      });
      return r;
    }

    function show(k) {
      var i = (k - 1) % n, sends = k > n, r = picture(k, function (row, j) {
        return k > 0 && (row === "to" ? sends && keep[i] && j === from[i]
          : j === i && (row !== "from" || sends)
            || !sends && row === "keep" && j === i - 1);
      });
      if (sends && keep[i]) {
        p.line([X + (i + 0.5) * draw.BOX, 175],
          [X + (r.place[i] + 0.5) * draw.BOX, 239], "stroke");
      }
      stage.say("Step " + k + " of " + 2 * n + ". " + (k === 0
        ? "First the scan of the marks, sum by sum; then each marked number "
        + "goes to its place." : !sends ? "Scan: " + (i === 0
          ? "nothing stands before " + from[0] + ", so its sum is 0."
          : r.place[i - 1] + " + " + keep[i - 1] + " = " + r.place[i] + ": "
          + marked(r.place[i]) + " before " + from[i] + ".")
          : from[i] + (keep[i] ? " is marked, and " + marked(r.place[i])
          + " before it: it goes to place " + r.place[i] + "."
          : " is not marked: it goes nowhere.") + (k === 2 * n ? " "
          + (r.count === 1 ? "1 number is" : r.count + " numbers are")
          + " kept." : "")));
    }

    var walk = draw.steps(stage, function () { return 2 * n; }, show);
    stage.button("From the beginning", function () { walk.go(0); });
    mark(3);
    var moved = changed(3).moved.length;
    stage.answer.textContent = "You said " + stage.predicted
      + (stage.predicted === moved ? ", and that is right" : ". It is " + moved)
      + ": " + changed(3).moved.join(", ") + ", all that stand behind 26. A "
      + "mark changes the place of everything behind it, so no number knows "
      + "its place alone; the scan tells all of them.";

    return {
      asked: function () { // 26 is marked, and what moves is said
        return keep[3] === 1 && stage.status.textContent.includes("3 of the "
          + "other numbers that are kept go one place up: 58, 93, 23.");
      },
      check: function () {
        for (var seed = 1; seed < 60; seed++) {
          var list = [], wanted = [], x = seed;
          for (var i = 0; i < seed; i++) {
            x = (x * 16807) % 2147483647;
            list.push(x % 1000);
            wanted.push(x >> 4 & 1);
          }
          var r = packed(list, wanted), plain = list.filter(function (_, i) {
            return wanted[i];
          });
          if (r.to.join() !== plain.join() || r.sum !== plain.length) {
            return false;
          }
        }
        return moved === 3; // 58, 93 and 23
      } };
  }
});
