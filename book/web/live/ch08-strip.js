// A strip of tasks that packs: lanes that wait for the longest task, and
// lanes that are given to others.
"use strict";

live("ch08-strip", {
  title: "a strip of tasks, with packing and without",
  ask: "24 searches run in vectors of eight lanes until the longest is done. "
    + "What share of the lanes, in percent, has work if nothing is packed?",

  show: function (stage) {
    var TASKS = 24, LANES = 8, c = stage.c, tasks, packs = true, last, seed = 1;
    var p = draw.picture(stage, 480, 340, "For each step the lanes of vectors "
      + "of eight: those with a task that still runs, and those without.");

    // How many candidates each search compares: its length as a task.
    function prepare() {
      c.generate("uniform", 2000, seed);
      c.set_geometry(1, 1, 1);
      c.sort_cells(1);
      tasks = c.u32(c.point(), TASKS);
      tasks = Array.from(tasks, function (i) {
        var n = c.spiral_cells(i);
        return c.u32(c.visited_points(), n).reduce(function (a, b) {
          return a + b;
        }, 0);
      });
      last = Math.max.apply(0, tasks);
    }

    // The tasks that go on after a step, by the book's pack.
    function packed(list, keep) {
      var at = c.room(4 * 4 * (list.length + 16)), m = c.memory.buffer;
      var step = 4 * (list.length + 16);
      new Uint32Array(m, at, list.length).set(list);
      new Uint8Array(m, at + step, list.length).set(keep);
      var n = c.pack(at + 2 * step, at, at + step, list.length);
      return Array.from(c.u32(at + 2 * step, n));
    }

    // The list of tasks before each step, up to one step.
    function lists(upto) {
      var list = tasks.map(function (_, t) { return t; }), result = [];
      for (var s = 0; s < upto; s++) {
        result.push(list);
        var keep = list.map(function (t) { return tasks[t] > s + 1 ? 1 : 0; });
        if (packs) list = packed(list, keep);
      }
      return result;
    }

    function tally(all) {
      var work = 0, lanes = 0;
      all.forEach(function (list, s) {
        list.forEach(function (t) { if (tasks[t] > s) work++; });
        lanes += Math.ceil(list.length / LANES) * LANES;
      });
      return { work: work, lanes: lanes };
    }

    function show(k) {
      var all = lists(k), H = Math.min(22, 300 / last), W = 17;
      p.clear();
      all.forEach(function (list, s) {
        var lanes = Math.ceil(list.length / LANES) * LANES;
        for (var i = 0; i < lanes; i++) {
          var t = list[i], runs = t !== undefined && tasks[t] > s;
          p.add("rect", { x: 20 + i * W + Math.floor(i / LANES) * 8,
            y: 12 + s * H, width: W - 2, height: H - 2,
            "class": "cell " + (runs ? "full" : "idle") });
        }
      });
      var sum = tally(all);
      p.tell("Lanes with work, step by step: " + all.map(function (list, s) {
        var one = list.filter(function (t) { return tasks[t] > s; }).length;
        return one + " of " + Math.ceil(list.length / LANES) * LANES;
      }).join(", ") + ".");
      stage.say("Step " + k + " of " + last + ": " + sum.work + " of "
        + sum.lanes + " lanes had work" + (sum.lanes ? ", "
        + Math.round(100 * sum.work / sum.lanes) + "%" : "") + ".");
    }

    var walk = draw.steps(stage, function () { return last; }, show);
    stage.choice("Lists are", ["packed after each step", "never packed"],
      function (k) { packs = k === 0; walk.go(walk.at()); });
    stage.button("Other tasks", function () { seed++; prepare(); walk.go(0); });
    prepare();
    packs = false;
    var without = tally(lists(last));
    packs = true;
    walk.go(1);
    stage.say("Without packing it is " + Math.round(100 * without.work
      / without.lanes) + "%; you said " + stage.predicted + ". Now step "
      + "through, packed and not.");

    return { check: function () {
      var before = packs;
      packs = true;
      var good = lists(last).every(function (list, s) {
        return list.join() === tasks.map(function (_, t) { return t; })
          .filter(function (t) { return s === 0 || tasks[t] > s; }).join();
      });
      packs = before;
      var found = c.u32(c.point(), 1)[0], n = c.spiral_cells(found);
      var nearest = c.u32(c.visited_nearest(), n)[n - 1];
      c.by("naive");
      return good && nearest === c.u32(c.nearest(), 2000)[found];
    } };
  }
});
