package enlightenment.world;

import enlightenment.primitive.Primitive;
import enlightenment.primitive.SpherePrimitive;
import enlightenment.world.contact.CoincidentSurfaces;
import enlightenment.world.light.MirroredLights;
import enlightenment.world.light.StrongestPairs;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.CancellationCheck;
import enlightenment.world.parts.CompiledPrimitives;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The spherical mirrors of a scene, each with a light that it may reflect: directions can be sampled within their images of the lights.
 * Immutable.
 *
 * <p>Only mirrors and lights that coincide with no other surface, so that the first hit of a ray is the surface itself. Of more than eight
 * pairs those with the largest estimated power are kept; caustics of the others are found by BSDF sampling only.
 */
public final class MirrorBalls {
    private static final int MOST_PAIRS = 8;

    /** By pair: the mirror. */
    public final SpherePrimitive[] mirror;

    /** By pair: the mirror's id. */
    public final int[] id;

    /** By pair: the index of the light. */
    public final int[] light;

    private MirrorBalls(List<StrongestPairs.Pair> pairs, Primitive[] primitives) {
        int n = pairs.size();
        mirror = new SpherePrimitive[n];
        id = new int[n];
        light = new int[n];
        for (int k = 0; k < n; k++) {
            id[k] = pairs.get(k).id();
            light[k] = pairs.get(k).light();
            mirror[k] = (SpherePrimitive) primitives[id[k]];
        }
    }

    /**
     * The pairs of a scene; null if there are none, or if paths may have fewer than two bounces.
     *
     * @param poll called regularly; what it throws ends this
     */
    static MirrorBalls of(
            CompiledPrimitives compiled, CoincidentSurfaces coincident, PhysicalScene physical, Runnable poll) {
        if (physical.maxBounces < 2) {
            return null;
        }
        CancellationCheck work = new CancellationCheck(poll);
        StrongestPairs best = new StrongestPairs(MOST_PAIRS);
        MirroredLights lights = null;
        long pairs = 0;
        for (int id = 0; id < compiled.primitives().length; id++) {
            if (isMirror(compiled, coincident, id)) {
                if (lights == null) {
                    int[] some = reflected(coincident, physical);
                    if (some.length == 0) {
                        return null;
                    }
                    lights = new MirroredLights(physical.lights, some, physical.visibleOfUltraviolet, work);
                }
                pairs += lights.count() - (physical.lightOf(id, 0) >= 0 ? 1 : 0);
                lights.offer((SpherePrimitive) compiled.primitives()[id], id, best);
            }
        }
        return pairs == 0
                ? null
                : new MirrorBalls(pairs > MOST_PAIRS ? best.byPower() : best.byId(), compiled.primitives());
    }

    /** The lights that may be reflected: those with extent and with constant radiance. */
    private static int[] reflected(CoincidentSurfaces coincident, PhysicalScene physical) {
        return IntStream.range(0, physical.lights.length)
                .filter(i -> !physical.lights[i].isPoint
                        && physical.lights[i].texture == null
                        && !coincident.concerns(physical.lights[i].id))
                .toArray();
    }

    private static boolean isMirror(CompiledPrimitives compiled, CoincidentSurfaces coincident, int id) {
        if (!(compiled.primitives()[id] instanceof SpherePrimitive) || coincident.concerns(id)) {
            return false;
        }
        SurfaceMaterial m = compiled.materials().of(id, 0);
        return m.isDelta && !m.isGlass && !m.isBlack;
    }

    /** The number of pairs. */
    public int pairs() {
        return id.length;
    }
}
