// Put points, and see the nearest and the furthest of each, in both
// geometries.
"use strict";

live("ch01-arrows", {
  title: "put points, and see who is nearest and furthest",
  ask: "If point A is the nearest of B, is B always the nearest of A?",
  choices: ["Always", "Not always"],
  because: "Not always: A may be the nearest of B while another point "
    + "is nearer to A. Below, each point's stroke leads to its nearest, and its "
    + "hair to its furthest.",

  show: function (stage) {
    var c = stage.c, geometry = 1, points = c.generate("uniform", 12, 3);
    var p = draw.plane(stage, "The unit square: click to put a point, click "
      + "a point to remove it; or move the cross with the arrow keys and "
      + "press Enter.", act, function (q) {
        return draw.place(q) + (hit(q) < 0 ? "" : ", where point " + hit(q)
          + " is");
      });
    var list = draw.list(stage, "The points in words");

    function hit(q) {
      return points.findIndex(function (r) {
        return Math.hypot(r[0] - q[0], r[1] - q[1]) < 0.02;
      });
    }

    function act(x, y) {
      var i = hit([x, y]);
      if (i >= 0) points.splice(i, 1); else points.push([x, y]);
      redraw();
      return i >= 0 ? "Point " + i + " removed." : "Point "
        + (points.length - 1) + " put at " + draw.place([x, y]) + ".";
    }

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

    function redraw() {
      p.frame();
      var mutual = 0, a = points.length > 1 ? answers() : null;
      points.forEach(function (q, i) {
        if (!a) return;
        p.segment(q, image(q, points[a.furthest[i]], false), "hair");
        p.segment(q, image(q, points[a.nearest[i]], true), "stroke");
        if (a.nearest[a.nearest[i]] === i) mutual++;
      });
      points.forEach(function (q) { p.dot(q, "dot", 4); });
      p.cross();
      list(points.map(function (q, i) {
        return "Point " + i + " at " + draw.place(q) + (a ? ": nearest "
          + a.nearest[i] + ", furthest " + a.furthest[i] : "");
      }));
      stage.say(a ? points.length + " points; " + mutual + " of them are the "
        + "nearest of their own nearest, " + new Set(a.furthest).size
        + " are the furthest of any." : "Two points are needed.");
    }

    stage.choice("Geometry", ["standard", "wraparound"], function (k) {
      geometry = k + 1;
      redraw();
    });
    stage.button("Other points", function () {
      points = c.generate("uniform", 12, 1 + Math.floor(Math.random() * 1e6));
      redraw();
    });
    stage.button("None", function () { points = []; redraw(); });
    redraw();

    return { check: function () {
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
