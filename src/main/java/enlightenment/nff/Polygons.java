package enlightenment.nff;

import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Triangle;
import enlightenment.math.ExactPoint;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Cuts flat polygons into shapes by clipping ears (Meisters, "Polygons have ears", 1975). All decisions are exact: signs
 * of areas in decimal arithmetic, on the coordinate plane that the polygon faces most, so there is nothing to tune.
 */
final class Polygons {
    private Polygons() {}

    /**
     * A polygon's parts: a rectangle where it is a parallelogram, otherwise triangles that have its vertices as theirs.
     * Parts too thin to span an area in doubles are left out.
     *
     * @return the parts, none of them where the polygon has no area; nothing where the polygon crosses itself
     */
    static Optional<List<Shape>> parts(List<ExactPoint> vertices) {
        List<ExactPoint> corners = withoutRepetitions(vertices);
        if (corners.size() == 4 && isParallelogram(corners)) {
            return Optional.of(List.of(new Rectangle(corners.get(0), corners.get(1), corners.get(2), corners.get(3))));
        }
        List<Shape> triangles = new ArrayList<>();
        int plane = facing(corners);
        if (plane < 0) {
            return Optional.of(triangles);
        }
        List<Projected> ring = project(corners, plane);
        if (crossesItself(ring) || !clip(ring, triangles)) {
            return Optional.empty();
        }
        return Optional.of(triangles);
    }

    private static List<ExactPoint> withoutRepetitions(List<ExactPoint> vertices) {
        List<ExactPoint> corners = new ArrayList<>();
        for (ExactPoint v : vertices) {
            if (corners.isEmpty() || !corners.get(corners.size() - 1).equals(v)) {
                corners.add(v);
            }
        }
        while (corners.size() > 1 && corners.get(corners.size() - 1).equals(corners.get(0))) {
            corners.remove(corners.size() - 1);
        }
        return corners;
    }

    private static boolean isParallelogram(List<ExactPoint> c) {
        for (int k = 0; k < 3; k++) {
            BigDecimal one = c.get(0).component(k).add(c.get(2).component(k));
            BigDecimal other = c.get(1).component(k).add(c.get(3).component(k));
            if (one.compareTo(other) != 0) {
                return false;
            }
        }
        return !ExactPoint.areCollinear(c.get(0), c.get(1), c.get(3));
    }

    /** The axis along which the polygon shows its largest area; −1 where it has none (Newell's normal, exact). */
    private static int facing(List<ExactPoint> c) {
        int best = -1;
        BigDecimal largest = BigDecimal.ZERO;
        for (int axis = 0; axis < 3; axis++) {
            BigDecimal area = twiceArea(project(c, axis)).abs();
            if (area.compareTo(largest) > 0) {
                largest = area;
                best = axis;
            }
        }
        return best;
    }

    private static List<Projected> project(List<ExactPoint> c, int axis) {
        List<Projected> ring = new ArrayList<>(c.size());
        for (ExactPoint p : c) {
            ring.add(new Projected(p, p.component((axis + 1) % 3), p.component((axis + 2) % 3)));
        }
        return ring;
    }

    private static BigDecimal twiceArea(List<Projected> ring) {
        BigDecimal sum = BigDecimal.ZERO;
        Projected before = ring.isEmpty() ? null : ring.get(ring.size() - 1);
        for (Projected p : ring) {
            sum = sum.add(before.u.multiply(p.v)).subtract(before.v.multiply(p.u));
            before = p;
        }
        return sum;
    }

    /** Whether two sides cross between their ends; sides may touch, as where a hole is joined to the outline. */
    private static boolean crossesItself(List<Projected> ring) {
        int n = ring.size();
        for (int i = 0; i < n; i++) {
            Projected a = ring.get(i);
            Projected b = ring.get((i + 1) % n);
            for (int j = i + 2; j < n; j++) {
                Projected c = ring.get(j);
                Projected d = ring.get((j + 1) % n);
                if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Clips ears until a triangle is left; false if there is no ear although corners are left. */
    private static boolean clip(List<Projected> ring, List<Shape> triangles) {
        int turn = twiceArea(ring).signum();
        int at = 0;
        int tried = 0;
        while (ring.size() > 3) {
            if (tried++ == ring.size()) {
                return false;
            }
            at %= ring.size();
            if (isEar(ring, at, turn)) {
                add(triangles, ring, at);
                ring.remove(at);
                tried = 0;
            } else {
                at++;
            }
        }
        // What the last corner spans has the sign of the whole, unless the ring crossed itself.
        if (turn(ring.get(0), ring.get(1), ring.get(2)) == -turn) {
            return false;
        }
        add(triangles, ring, 1);
        return true;
    }

    private static boolean isEar(List<Projected> ring, int at, int turn) {
        int n = ring.size();
        Projected a = ring.get((at + n - 1) % n);
        Projected b = ring.get(at);
        Projected c = ring.get((at + 1) % n);
        if (turn(a, b, c) != turn) {
            return false;
        }
        for (Projected p : ring) {
            // Where a hole is joined to the outline by a cut, its corners appear twice and touch the ear.
            boolean corner = p.isAt(a) || p.isAt(b) || p.isAt(c);
            if (!corner && turn(a, b, p) != -turn && turn(b, c, p) != -turn && turn(c, a, p) != -turn) {
                return false;
            }
        }
        return true;
    }

    private static void add(List<Shape> triangles, List<Projected> ring, int at) {
        int n = ring.size();
        ExactPoint a = ring.get((at + n - 1) % n).point;
        ExactPoint b = ring.get(at).point;
        ExactPoint c = ring.get((at + 1) % n).point;
        if (!ExactPoint.areCollinear(a, b, c)) {
            triangles.add(new Triangle(a, b, c));
        }
    }

    /** 1 where a, b, c turn left, −1 right, 0 in one line. */
    private static int turn(Projected a, Projected b, Projected c) {
        BigDecimal left = b.u.subtract(a.u).multiply(c.v.subtract(a.v));
        BigDecimal right = b.v.subtract(a.v).multiply(c.u.subtract(a.u));
        return left.compareTo(right);
    }

    private record Projected(ExactPoint point, BigDecimal u, BigDecimal v) {
        boolean isAt(Projected o) {
            return u.compareTo(o.u) == 0 && v.compareTo(o.v) == 0;
        }
    }
}
