// Put points, and see the nearest and the furthest of each, in both
// geometries.
"use strict";

live("ch01-arrows", {
  title: "put points, and see who is nearest and furthest",
  ask: "If point A is the nearest of B, is B always the nearest of A?",
  choices: ["Always", "Not always"],
  because: "It is not always so: A may be the nearest of B while another point "
    + "is nearer to A. Such an arrow has one head; where two points are "
    + "the nearest of each other, it has two.",

  show: function (stage) {
    var c = stage.c, geometry = 1, points = c.generate("uniform", 12, 3);
    var HIT = 0.02, held = -1, dragged = false;
    var p = draw.plane(stage, "The unit square: click to put a point, click "
      + "a point to remove it, drag it to move it; or move the cross with the "
      + "arrow keys and press Enter.", act, function (q) {
        var i = at(q[0], q[1]);
        return draw.place(q) + (i < 0 ? "" : ", where point " + i + " is");
      });
    var list = draw.list(stage, "The points in words");
    stage.box.after(live.element("p", { "class": "hint" }, "Thick arrows lead "
      + "to the nearest, thin lines to the furthest; a point with a ring is "
      + "the furthest of some point. In wraparound, a line that leaves the "
      + "square comes in again on the other side. Click to put a point or to "
      + "take one away, drag one to move it; by keyboard, go to the picture, "
      + "move the cross with the arrow keys (with Shift, in larger steps) and "
      + "press Enter."));

    function at(x, y) {
      return points.findIndex(function (q) {
        return Math.hypot(q[0] - x, q[1] - y) < HIT;
      });
    }

    function act(x, y) {
      if (dragged) { dragged = false; return; } // the click that ends a drag
      var hit = at(x, y);
      if (hit >= 0) points.splice(hit, 1); else points.push([x, y]);
      redraw();
      return hit >= 0 ? "Point " + hit + " removed." : "Point "
        + (points.length - 1) + " put at " + draw.place([x, y]) + ".";
    }

    // A pointer that goes down on a point takes it along.
    function place(event) {
      var e = new DOMPoint(event.clientX, event.clientY).matrixTransform(
        p.svg.getScreenCTM().inverse());
      var low = p.at([0, 0]), high = p.at([1, 1]);
      return [(e.x - low[0]) / (high[0] - low[0]),
        (e.y - low[1]) / (high[1] - low[1])].map(function (v) {
        return Math.min(1, Math.max(0, v));
      });
    }
    p.svg.addEventListener("pointerdown", function (event) {
      held = at.apply(null, place(event));
      dragged = false;
    });
    p.svg.addEventListener("pointermove", function (event) {
      if (held < 0) return;
      var to = place(event), q = points[held];
      if (!dragged && Math.hypot(to[0] - q[0], to[1] - q[1]) < HIT) return;
      if (!dragged) p.svg.setPointerCapture(event.pointerId);
      dragged = true;
      points[held] = to;
      redraw();
    });
    ["pointerup", "pointercancel"].forEach(function (name) {
      p.svg.addEventListener(name, function () { held = -1; });
    });
    p.svg.addEventListener("keydown", function () { dragged = false; });
    p.svg.style.touchAction = "pinch-zoom";

    // The image of b that is meant: along each axis straight, or around.
    function image(a, b, nearest) {
      if (geometry === 1) return b;
      return [0, 1].map(function (k) {
        var d = Math.abs(b[k] - a[k]), around = 1 - d;
        if (nearest ? d <= around : d >= around) return b[k];
        return b[k] + (b[k] < a[k] ? 1 : -1);
      });
    }

    function answers() {
      var n = points.length;
      c.points(points);
      c.set_geometry(geometry, 1, 1);
      c.by("near-and-far");
      return { nearest: c.u32(c.nearest(), n), furthest: c.u32(c.furthest(), n) };
    }

    // A line from a to an image of b, and all its images in the square: it
    // goes out on one side and comes in on the other. The ends of an arrow
    // keep a little off the points, so that the head is seen.
    function line(a, b, nearest, kind) {
      var to = image(a, b, nearest), dx = to[0] - a[0], dy = to[1] - a[1];
      var length = Math.hypot(dx, dy), drawn = {};
      [0, to[0] - b[0]].forEach(function (x) {
        [0, to[1] - b[1]].forEach(function (y) {
          var begin = [a[0] - x, a[1] - y], end = [to[0] - x, to[1] - y];
          if (drawn[[x, y]]) return;
          drawn[[x, y]] = true;
          inside.append(p.segment(begin, end, kind));
          if (nearest && length > 0) {
            head(end, dx / length, dy / length, Math.min(1, length / 0.06));
          }
        });
      });
    }

    function head(tip, dx, dy, size) {
      var t = p.at(tip), back = 5 * size, long = 11 * size, wide = 4.5 * size;
      var x = t[0] - back * dx, y = t[1] + back * dy; // y is downward there
      inside.append(p.add("path", { "class": "head", d: "M" + x + " " + y
        + "L" + (x - long * dx - wide * dy) + " " + (y + long * dy - wide * dx)
        + "L" + (x - long * dx + wide * dy) + " " + (y + long * dy + wide * dx)
        + "Z" }));
    }

    var inside; // what is cut off at the square

    function redraw() {
      p.frame();
      var a = points.length > 1 ? answers() : null, mutual = 0;
      var low = p.at([0, 1]), side = p.at([1, 0])[0] - low[0];
      inside = p.add("svg", { x: low[0], y: low[1], width: side, height: side,
        viewBox: [low[0], low[1], side, side].join(" ") });
      if (a) {
        points.forEach(function (q, i) {
          line(q, points[a.furthest[i]], false, "hair");
        });
        points.forEach(function (q, i) {
          line(q, points[a.nearest[i]], true, "stroke");
          if (a.nearest[a.nearest[i]] === i) mutual++;
        });
        new Set(a.furthest).forEach(function (i) {
          p.dot(points[i], "round", 8);
        });
      }
      points.forEach(function (q) { p.dot(q, "dot", 4); });
      p.cross();
      list(points.map(function (q, i) {
        return "Point " + i + " at " + draw.place(q) + (a ? ": nearest "
          + a.nearest[i] + ", furthest " + a.furthest[i] : "");
      }));
      stage.say(a ? points.length + " points; " + mutual + " of them are the "
        + "nearest of their own nearest, and " + many(new Set(a.furthest).size)
        + " the furthest of some point." : "Two points are needed.");
    }

    function many(n) { return n + (n === 1 ? " is" : " are"); }

    stage.choice("Geometry", ["standard", "wraparound"], function (k) {
      geometry = k + 1;
      redraw();
    });
    stage.button("Other points", function () {
      points = c.generate("uniform", 12, 1 + Math.floor(Math.random() * 1e6));
      redraw();
    });
    stage.button("Take all points away", function () { points = []; redraw(); });
    redraw();

    return {
      points: function () { return points.length; },
      asked: function () { // whether there is what the question is about
        var a = answers().nearest;
        return a.some(function (j, i) { return a[j] !== i; });
      },
      check: function () {
        for (geometry = 1; geometry <= 2; geometry++) {
          var fast = answers();
          c.by("naive");
          var n = points.length, slow = [c.u32(c.nearest(), n),
            c.u32(c.furthest(), n)];
          if (fast.nearest.join() !== slow[0].join()
            || fast.furthest.join() !== slow[1].join()) return false;
        }
        geometry = 1;
        return true;
      } };
  }
});
