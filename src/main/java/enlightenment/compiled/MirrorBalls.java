package enlightenment.compiled;

import enlightenment.primitive.Primitive;
import enlightenment.primitive.SpherePrimitive;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * The mirrors of a scene that are spheres, each with a light that it may reflect: their images of lights can be aimed at. Immutable.
 *
 * <p>Only mirrors and lights that coincide with no other surface, so that the first hit of a ray is the surface itself. Of more than eight
 * pairs those with the largest estimated power are kept; the others' caustics are found by BSDF sampling only.
 */
public final class MirrorBalls {
    private static final int MOST_PAIRS = 8;

    /** By pair: the mirror. */
    public final SpherePrimitive[] mirror;

    /** By pair: the mirror's id. */
    public final int[] id;

    /** By pair: the index of the light. */
    public final int[] light;

    private MirrorBalls(List<Pair> pairs, Primitive[] primitives) {
        int n = pairs.size();
        mirror = new SpherePrimitive[n];
        id = new int[n];
        light = new int[n];
        for (int k = 0; k < n; k++) {
            id[k] = pairs.get(k).id;
            light[k] = pairs.get(k).light;
            mirror[k] = (SpherePrimitive) primitives[id[k]];
        }
    }

    private record Pair(int id, int light, double power) {}

    /** The pairs of a scene; null if there are none, or paths end too soon. */
    static MirrorBalls of(CompiledScene scene, PhysicalScene physical) {
        if (physical.maxBounces < 2) {
            return null;
        }
        List<Pair> pairs = new ArrayList<>();
        for (int id = 0; id < scene.primitives.length; id++) {
            if (isMirror(scene, id)) {
                for (int light = 0; light < physical.lights.length; light++) {
                    PhysicalLight l = physical.lights[light];
                    if (!l.isPoint && l.id != id && !scene.coincident.concerns(l.id)) {
                        pairs.add(new Pair(id, light, power((SpherePrimitive) scene.primitives[id], l, physical)));
                    }
                }
                keepBest(pairs);
            }
        }
        return pairs.isEmpty() ? null : new MirrorBalls(pairs, scene.primitives);
    }

    private static boolean isMirror(CompiledScene scene, int id) {
        if (!(scene.primitives[id] instanceof SpherePrimitive) || scene.coincident.concerns(id)) {
            return false;
        }
        SurfaceMaterial m = scene.material(id, 0);
        return m.isDelta && !m.isGlass && !m.isBlack;
    }

    private static void keepBest(List<Pair> pairs) {
        if (pairs.size() > MOST_PAIRS) {
            pairs.sort(Comparator.<Pair>comparingDouble(p -> -p.power)
                    .thenComparingInt(Pair::id)
                    .thenComparingInt(Pair::light));
            pairs.subList(MOST_PAIRS, pairs.size()).clear();
        }
    }

    /** About how much of a light's power comes to a mirror, but for a factor. */
    private static double power(SpherePrimitive mirror, PhysicalLight l, PhysicalScene scene) {
        double x = mirror.x() - l.ballX;
        double y = mirror.y() - l.ballY;
        double z = mirror.z() - l.ballZ;
        double share = mirror.radius() * mirror.radius() / (x * x + y * y + z * z);
        double brightest = Math.max(Math.max(l.r, Math.max(l.g, l.b)), scene.visibleOfUltraviolet * l.ultraviolet);
        return brightest * l.form.area() * Math.min(share, 1);
    }

    /** The number of pairs. */
    public int pairs() {
        return id.length;
    }
}
