// Two threads add 1 to the same count, a step at a time, in any order.
"use strict";

live("ch03-lost-update", {
  title: "interleave two threads by hand",
  ask: "The count is 5, and two threads each add 1 to it. What can it be "
    + "afterwards?",
  choices: ["Always 7", "6 or 7", "5, 6 or 7"],
  because: "6 or 7: it is 6 if both load before either stores.",

  show: function (stage) {
    var STEPS = ["load the count", "add 1", "store the sum"], seen = {};
    var s, p = draw.picture(stage, 480, 230, "The count in memory and a "
      + "register of each of two threads.");

    function start() {
      s = { count: 5, register: [null, null], at: [0, 0], order: "" };
      redraw("Let either thread take a step.");
    }

    // What a thread does next, to a state that is its own.
    function advance(state, t) {
      if (state.at[t] === 0) state.register[t] = state.count;
      if (state.at[t] === 1) state.register[t]++;
      if (state.at[t] === 2) state.count = state.register[t];
      state.at[t]++;
      state.order += "AB"[t];
    }

    function step(t) {
      if (s.at[t] === 3) return;
      var did = STEPS[s.at[t]];
      advance(s, t);
      var said = "Thread " + "AB"[t] + ": " + did + ".";
      if (s.at[0] + s.at[1] === 6) {
        seen[s.order] = s.count;
        said += " Both are done, and the count is " + s.count + (s.count === 7
          ? ": nothing is lost." : ": an update is lost.") + " You have seen "
          + Object.keys(seen).length + " of 20 orders.";
      }
      redraw(said);
    }

    function redraw(said) {
      p.clear();
      draw.boxes(p, 220, 20, [s.count], { label: "count in memory",
        kinds: ["lit"] });
      [0, 1].forEach(function (t) {
        var x = 130 + 220 * t;
        draw.boxes(p, x, 85, [s.register[t]], { label: "thread " + "AB"[t] });
        STEPS.forEach(function (text, k) {
          p.add("text", { x: x - 90, y: 155 + 24 * k, "class": "step "
            + (k < s.at[t] ? "done" : k === s.at[t] ? "next" : "") },
            (k < s.at[t] ? "✓ " : k === s.at[t] ? "→ " : "   ") + text);
        });
      });
      stage.enable(a, s.at[0] < 3);
      stage.enable(b, s.at[1] < 3);
      stage.say(said);
    }

    var a = stage.button("Step A", function () { step(0); });
    var b = stage.button("Step B", function () { step(1); });
    stage.button("Begin again", start);
    start();

    // All orders: an update is lost unless one thread stores before the
    // other one loads.
    function orders(order, left, found) {
      if (left[0] + left[1] === 0) { found.push(order); return found; }
      [0, 1].forEach(function (t) {
        if (!left[t]) return;
        var rest = left.slice();
        rest[t]--;
        orders(order.concat(t), rest, found);
      });
      return found;
    }

    return { check: function () {
      var all = orders([], [3, 3], []);
      return all.length === 20 && all.every(function (order) {
        var state = { count: 5, register: [0, 0], at: [0, 0], order: "" };
        order.forEach(function (t) { advance(state, t); });
        var apart = order.slice(0, 3).every(function (t) {
          return t === order[0];
        });
        return state.count === (apart ? 7 : 6);
      });
    } };
  }
});
