// Two threads improve the same best distance, a step at a time, in any
// order.
"use strict";

live("ch03-lost-update", {
  title: "interleave two threads by hand",
  ask: "The best of point 7 is 0.5. Thread A comes with 0.3, thread B with "
    + "0.4. Each makes three steps: it reads the best, compares, and stores "
    + "its own distance if that is smaller than what it read. Their six steps "
    + "can follow each other in 20 orders. In how many of them is the best "
    + "wrong at the end?",

  show: function (stage) {
    var OWN = [0.3, 0.4], seen = {}, s;
    var p = draw.picture(stage, 480, 250, "The best in memory, and what each "
      + "of two threads has read and does next.");
    stage.answer.textContent = "You said " + stage.predicted
      + (stage.predicted === 9 ? ", and that is right" : ". It is 9")
      + ". In 18 of the 20 orders both threads read before either stores, but "
      + "in half of these it is 0.3 that is stored last, and the loss does not "
      + "show. Find the two orders in which they do not overlap.";

    function fresh() {
      return { best: 0.5, read: [null, null], smaller: [null, null],
        at: [0, 0], order: "" };
    }

    // What a thread does next, to a state that is its own.
    function advance(state, t) {
      if (state.at[t] === 0) state.read[t] = state.best;
      if (state.at[t] === 1) state.smaller[t] = OWN[t] < state.read[t];
      if (state.at[t] === 2 && state.smaller[t]) state.best = OWN[t];
      state.at[t]++;
      state.order += "AB"[t];
    }

    function done(state) { return state.order.length === 6; }

    function overlaps(order) {
      return order !== "AAABBB" && order !== "BBBAAA";
    }

    function did(state, t) { // in words, what the last step was
      return "Thread " + "AB"[t] + (state.at[t] === 1 ? " reads "
        + state.read[t] + "." : state.at[t] === 2 ? " compares: " + OWN[t]
        + " is " + (state.smaller[t] ? "" : "not ") + "smaller than "
        + state.read[t] + "." : state.smaller[t] ? " stores " + OWN[t] + "."
        : " stores nothing.");
    }

    function step(t) {
      if (s.at[t] === 3) return;
      advance(s, t);
      var said = did(s, t);
      if (done(s)) said += " " + ended();
      redraw(said);
    }

    function ended() {
      seen[s.order] = s.best;
      return "Both are done, in the order " + s.order + ", and the best is "
        + s.best + (s.best > 0.3 ? ": the update of A is lost." : overlaps(
          s.order) ? ": right, though both read 0.5, as A stores last."
          : ": right, as one thread begins when the other one is done.");
    }

    function play(order) {
      s = fresh();
      Array.from(order).forEach(function (t) { advance(s, "AB".indexOf(t)); });
      redraw(ended());
    }

    function start() {
      s = fresh();
      redraw("Let either thread take a step.");
    }

    function redraw(said) {
      p.clear();
      draw.boxes(p, 220, 20, [s.best], { label: "best of point 7, in memory",
        kinds: ["lit"] });
      [0, 1].forEach(function (t) {
        var x = 135 + 235 * t, own = OWN[t], read = s.read[t];
        p.add("text", { x: x - 110, y: 82, "class": "step" }, "Thread "
          + "AB"[t] + " comes with " + own);
        draw.boxes(p, x, 98, [read], { label: "has read" });
        ["read the best", "compare" + (s.smaller[t] === null ? "" : ": " + own
          + (s.smaller[t] ? " < " : " ≥ ") + read), s.smaller[t] === false
          ? "do not store" : "store " + own + (s.smaller[t] === null
          ? " if smaller" : "")].forEach(function (text, k) {
          p.add("text", { x: x - 110, y: 165 + 26 * k, "class": "step "
            + (k < s.at[t] ? "done" : k === s.at[t] ? "next" : "") },
            (k < s.at[t] ? "✓ " : k === s.at[t] ? "→ " : "   ") + text);
        });
      });
      stage.enable(a, s.at[0] < 3);
      stage.enable(b, s.at[1] < 3);
      stage.say(said);
      list();
    }

    var a = stage.button("Step A", function () { step(0); });
    var b = stage.button("Step B", function () { step(1); });
    stage.button("Begin again", start);
    stage.button("Play all 20 orders", function () {
      all.forEach(play);
    });

    // Every way to merge so many steps of A and of B.
    function orders(left_a, left_b) {
      if (left_a + left_b === 0) return [""];
      function begin(letter, rest) {
        return rest.map(function (order) { return letter + order; });
      }
      return (left_a ? begin("A", orders(left_a - 1, left_b)) : [])
        .concat(left_b ? begin("B", orders(left_a, left_b - 1)) : []);
    }

    // The list of all orders, with what came of those that were played.
    var all = orders(3, 3), sum = live.element("p", { "class": "hint" });
    var items = all.map(function (order) {
      var item = live.element("button", { type: "button" }, order);
      item.addEventListener("click", function () { play(order); });
      return item;
    });
    stage.status.after(sum, live.element("div", { "class": "panel orders",
      role: "group", "aria-label": "The orders" }, items));

    function list() {
      var played = Object.keys(seen), wrong = played.filter(function (order) {
        return seen[order] > 0.3;
      });
      all.forEach(function (order, k) {
        items[k].textContent = order + (order in seen ? " " + seen[order] : "");
        items[k].className = !(order in seen) ? "" : seen[order] > 0.3
          ? "wrong" : "kept";
      });
      sum.textContent = "All 20 orders; press one to play it. So far "
        + played.length + (played.length === 1 ? " has" : " have")
        + " been played, and the best was wrong at the end of "
        + wrong.length + ".";
    }

    start();

    // In another way: the best is wrong if B has read before A stores, and
    // stores after it.
    return {
      asked: function () { // the number asked for is what one can count
        all.forEach(play);
        return sum.textContent.includes("So far 20 have been played, and the "
          + "best was wrong at the end of 9.");
      },
      check: function () {
        var wrong = 0, overlap = 0;
        return all.length === 20 && new Set(all).size === 20
          && all.every(function (order) {
            var state = fresh(), store = order.lastIndexOf("A");
            Array.from(order).forEach(function (t) {
              advance(state, "AB".indexOf(t));
            });
            var lost = order.indexOf("B") < store
              && order.lastIndexOf("B") > store;
            if (lost) wrong++;
            if (order.indexOf("B") < store && order.indexOf("A")
              < order.lastIndexOf("B")) overlap++;
            return state.best === (lost ? 0.4 : 0.3);
          }) && wrong === 9 && overlap === 18;
      } };
  }
});
