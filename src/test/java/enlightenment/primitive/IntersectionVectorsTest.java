package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The rays of intersection-vectors.jsonl, whose distances are known to 25 digits. */
class IntersectionVectorsTest {
    /** Rays closer than this to the border between hit and miss may be decided either way. */
    private static final double DECIDED_MARGIN = 1024;

    private static Primitive primitive(Vectors.Case c) {
        double r = c.number("radius");
        return switch (c.kind()) {
            case "sphere" -> new SpherePrimitive(c.triple("center"), r, new Vec3(0, 0, -1));
            case "cylinder" -> new CylinderPrimitive(c.triple("p1"), c.triple("p2"), r, true);
            case "cone" -> new ConePrimitive(c.triple("base"), c.triple("apex"), r, 0, true);
            default -> throw new IllegalArgumentException(c.kind());
        };
    }

    /** The data calls a cone's base face 2. */
    private static int face(Vectors.Case c) {
        int face = Integer.parseInt(c.texts().get("face"));
        return c.kind().equals("cone") && face == 2 ? AxialPrimitive.BASE : face;
    }

    @ParameterizedTest
    @ValueSource(strings = {"sphere", "cylinder", "cone"})
    void everyVectorIsHitOrMissedAsItsExactDistanceSays(String kind) {
        List<String> wrong = new ArrayList<>();
        List<Vectors.Case> cases = Vectors.of(kind);
        for (Vectors.Case c : cases) {
            Primitive p = primitive(c);
            double t = p.nearest(c.ray(), Double.MAX_VALUE);
            boolean decided = c.margin() >= DECIDED_MARGIN;
            if (decided && (t != Primitive.MISS) != c.hit()) {
                wrong.add("hit is " + (t != Primitive.MISS) + ": " + c);
            }
            if (decided && c.hit() && t != Primitive.MISS) {
                BigDecimal miss = new BigDecimal(t).subtract(c.decimal("t")).abs();
                if (miss.compareTo(c.decimal("tTol")) > 0) {
                    wrong.add("t is " + t + ": " + c);
                }
            }
        }
        assertTrue(cases.size() >= 17 * 6, kind + " vectors are there");
        assertEquals(List.of(), wrong);
    }

    @ParameterizedTest
    @ValueSource(strings = {"sphere", "cylinder", "cone"})
    void everyHitPointLiesWithinEightUlpsOfTheSurface(String kind) {
        List<String> wrong = new ArrayList<>();
        double worst = 0;
        int hits = 0;
        for (Vectors.Case c : Vectors.of(kind)) {
            Primitive p = primitive(c);
            Hit hit = new Hit();
            if (!p.intersect(c.ray(), hit)) {
                continue;
            }
            hits++;
            double distance = ExactSolid.of(p).distance(hit.point()) / pointUlp(p, hit.point());
            worst = Math.max(worst, distance);
            if (distance > 8) {
                wrong.add(distance + " ulp from the surface: " + c);
            }
            if (Math.abs(hit.normal().length() - 1) > 0x1p-50) {
                wrong.add("normal of length " + hit.normal().length() + ": " + c);
            }
            if (c.margin() >= DECIDED_MARGIN && hit.face != face(c)) {
                wrong.add("face " + hit.face + ": " + c);
            }
        }
        assertEquals(List.of(), wrong);
        assertTrue(hits > 20, hits + " hits");
        assertTrue(worst < 8, "the worst is " + worst + " ulp");
    }

    /** The unit that distances from a surface are counted in. */
    static double pointUlp(Primitive p, Vec3 point) {
        Vec3 extent = p.bounds().extent();
        return Math.ulp(Math.max(point.maxAbs(), Math.max(p.bounds().maxAbs(), extent.maxAbs())));
    }
}
