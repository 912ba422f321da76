// What an octagon leaves over, and the corners of the hull.
"use strict";

live("ch10-octagon", {
  title: "throw points away with an octagon",
  ask: "Of 1,000 uniform points, how many can be the furthest of any?",

  show: function (stage) {
    var N = 1000, c = stage.c, kinds = ["uniform", "kuzmin", "circle",
      "clustered", "lattice"], kind = 0, seed = 1, points = [];
    var p = draw.plane(stage, "Points, those outside of an octagon, and the "
      + "corners of their convex hull.");

    function scaled(list) {
      var x = list.map(function (q) { return q[0]; });
      var y = list.map(function (q) { return q[1]; });
      var low = [Math.min.apply(0, x), Math.min.apply(0, y)];
      var size = Math.max(Math.max.apply(0, x) - low[0],
        Math.max.apply(0, y) - low[1]) || 1;
      return list.map(function (q) {
        return [(q[0] - low[0]) / size, (q[1] - low[1]) / size];
      });
    }

    function ask() {
      c.points(points);
      c.set_geometry(1, 1, 1);
      var left = c.octagon(), kept = c.u32(c.outside_octagon(), left);
      return { kept: kept, sides: sides(), corners: hull() };
    }

    function hull() {
      var n = c.hull();
      return c.u32(c.hull_corner(), n);
    }

    // The octagon: the unit square, cut by each side a x + b y > c.
    function sides() {
      c.octagon();
      var a = c.f64(c.side_a(), 8), b = c.f64(c.side_b(), 8);
      var s = c.f64(c.side_c(), 8), left = c.side_left();
      var bottom = c.side_bottom(), shape = [[0, 0], [1, 0], [1, 1], [0, 1]];
      for (var k = 0; k < 8; k++) {
        var cut = [];
        shape.forEach(function (q, i) {
          var r = shape[(i + 1) % shape.length];
          var f = a[k] * (q[0] - left) + b[k] * (q[1] - bottom) - s[k];
          var g = a[k] * (r[0] - left) + b[k] * (r[1] - bottom) - s[k];
          if (f >= 0) cut.push(q);
          if (f >= 0 !== g >= 0) {
            cut.push([q[0] + (r[0] - q[0]) * f / (f - g),
              q[1] + (r[1] - q[1]) * f / (f - g)]);
          }
        });
        shape = cut;
      }
      return shape;
    }

    function redraw() {
      points = scaled(c.generate(kinds[kind], N, seed));
      var a = ask(), kept = new Set(a.kept), corner = new Set(a.corners);
      p.frame();
      p.add("polygon", { points: a.sides.map(function (q) {
        return p.at(q).join(",");
      }).join(" "), "class": "wash line" });
      points.forEach(function (q, i) {
        if (!kept.has(i)) p.dot(q, "faint", 1.8);
      });
      points.forEach(function (q, i) {
        if (kept.has(i) && !corner.has(i)) p.dot(q, "dot", 3);
      });
      points.forEach(function (q, i) { if (corner.has(i)) p.dot(q, "query", 4.5); });
      stage.say("Of " + N + " points the octagon leaves " + a.kept.length
        + "; of these, " + a.corners.length + " are corners, and only they can "
        + "be the furthest of any.");
    }

    stage.choice("Points", kinds, function (k) { kind = k; redraw(); });
    stage.button("Other points", function () { seed++; redraw(); });
    redraw();
    stage.say(stage.status.textContent + " You said " + stage.predicted + ".");

    // Whoever is the furthest of a point is a corner, and was left over.
    return { check: function () {
      var before = kind, good = true;
      for (kind = 0; kind < kinds.length; kind++) {
        points = scaled(c.generate(kinds[kind], N, seed));
        var a = ask(), corner = new Set(a.corners), kept = new Set(a.kept);
        c.by("naive");
        c.u32(c.furthest(), N).forEach(function (j) {
          if (!corner.has(j) || !kept.has(j)) good = false;
        });
      }
      kind = before;
      redraw();
      return good;
    } };
  }
});
