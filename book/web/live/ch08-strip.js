// A strip of tasks without packing and with it, side by side: lanes that
// wait for the longest task, and lanes that are given to others.
"use strict";

live("ch08-strip", {
  title: "a strip of tasks, without packing and with it",
  ask: "24 searches are 24 lanes, in three vectors of eight. At each step, "
    + "every search that is not done compares a point. The longest compares "
    + "7, all together 80. If nothing is packed, all three vectors "
    + "go on until the longest search is done. What share of the lanes has "
    + "work then, over all steps, in percent?",

  show: function (stage) {
    var TASKS = 24, lanes = 8, c = stage.c, tasks, last, seed = 1;
    var p = draw.picture(stage, 480, 340, "For each step the lanes of the "
      + "vectors, left without packing and right with it: those in which a "
      + "search compares a point, and those without work.");
    stage.box.after(live.element("p", { "class": "hint" }, [
      "A row is a step, a box a lane, a group a vector: ",
      live.element("span", { "class": "key full" }), " a search compares a "
      + "point; ", live.element("span", { "class": "key" }), " no work, as "
      + "the search is done or no search is left for the lane. Where there "
      + "is no box, no vector is needed any more. A lane counts once for each "
      + "step."]));

    // How many points each search compares: its length as a task.
    function prepare() {
      c.generate("uniform", 2000, seed);
      c.set_geometry(1, 1, 1);
      c.sort_cells(1);
      tasks = Array.from(c.u32(c.point(), TASKS), function (i) {
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

    // The list of tasks at each step, up to one step.
    function lists(upto, packs) {
      var list = tasks.map(function (_, t) { return t; }), result = [];
      for (var s = 0; s < upto; s++) {
        result.push(list);
        var keep = list.map(function (t) { return tasks[t] > s + 1 ? 1 : 0; });
        if (packs) list = packed(list, keep);
      }
      return result;
    }

    function whole(n) { return Math.ceil(n / lanes) * lanes; }

    function tally(all) {
      var work = 0, sum = 0;
      all.forEach(function (list, s) {
        list.forEach(function (t) { if (tasks[t] > s) work++; });
        sum += whole(list.length);
      });
      return { work: work, lanes: sum,
        percent: Math.round(100 * work / sum) };
    }

    function side(x, all, name) {
      p.tell("Lanes with work, " + name + ", step by step: "
        + all.map(function (list, s) {
          var work = list.filter(function (t) { return tasks[t] > s; });
          return work.length + " of " + whole(list.length);
        }).join(", ") + ".");
      var W = 198 / whole(TASKS), H = Math.min(34, 285 / last);
      var group = lanes * W + 5;
      p.add("text", { x: x, y: 15 }, name);
      for (var v = 0; v * lanes < TASKS; v++) {
        p.add("text", { x: x + v * group + lanes * W / 2, y: 34, "class":
          "index" }, (group > 60 ? "vector " : "") + v);
      }
      all.forEach(function (list, s) {
        for (var i = 0; i < whole(list.length); i++) {
          var t = list[i], runs = t !== undefined && tasks[t] > s;
          p.add("rect", { x: x + i * W + 5 * Math.floor(i / lanes),
            y: 42 + s * H, width: W - 1.5, height: H - 3,
            "class": "cell " + (runs ? "full" : "idle") });
        }
        if (x < 100) p.add("text", { x: x - 8, y: 42 + s * H + H / 2 + 3,
          "class": "row" }, s + 1);
      });
    }

    function said(name, all) {
      var sum = tally(all);
      return " " + name + ", " + sum.work + " of " + sum.lanes
        + " lanes had work: " + sum.percent + "%.";
    }

    function show(k) {
      var without = lists(k, false), having = lists(k, true);
      p.clear();
      side(42, without, "not packed");
      side(270, having, "packed after each step");
      p.add("text", { x: 34, y: 34, "class": "row" }, "step");
      stage.say(k === 0 ? "No step has been made. Press Step."
        : (k === 1 ? "After 1 step" : "After " + k + " steps") + " of " + last
        + "." + said("Not packed", without)
        + said("Packed", having));
    }

    var walk = draw.steps(stage, function () { return last; }, show);
    stage.button("From the beginning", function () { walk.go(0); });
    stage.button("Make the longest search longer", function () {
      if (last < 20) tasks[tasks.indexOf(last)] = ++last;
      walk.go(last);
    });
    stage.button("Other searches", function () {
      seed++;
      prepare();
      walk.go(last);
    });
    var sizes = [8, 4, 16];
    stage.choice("Lanes in a vector", sizes, function (k) {
      lanes = sizes[k];
      walk.go(walk.at());
    });
    prepare();
    var without = tally(lists(last, false));
    stage.answer.textContent = "You said " + stage.predicted + "%. It is "
      + without.percent + "%" + (Math.abs(stage.predicted - without.percent) < 4
        ? ", so you are right" : "") + ": " + without.work + " of the 24 · "
      + last + " = " + without.lanes + " lanes. That is the length of a search "
      + "on average, over that of the longest. Make the longest search longer, "
      + "and see how much of each share is lost.";
    walk.go(last);

    return {
      asked: function () { // the share without packing can be read
        return stage.status.textContent.includes("Not packed, 80 of 168 lanes "
          + "had work: 48%.");
      },
      check: function () {
        var sum = tasks.reduce(function (a, b) { return a + b; }, 0);
        var good = sum === 80 && last === 7; // what the question tells
        good = good && without.work === sum && without.lanes === TASKS * last;
        good = good && lists(last, true).every(function (list, s) {
          return list.join() === tasks.map(function (_, t) { return t; })
            .filter(function (t) { return tasks[t] > s; }).join();
        });
        var found = c.u32(c.point(), 1)[0], n = c.spiral_cells(found);
        var nearest = c.u32(c.visited_nearest(), n)[n - 1];
        c.by("naive");
        return good && nearest === c.u32(c.nearest(), 2000)[found];
      } };
  }
});
