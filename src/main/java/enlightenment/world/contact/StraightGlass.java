package enlightenment.world.contact;

import enlightenment.accel.Accelerator;
import enlightenment.accel.BvhQuery;
import enlightenment.frame.Bounds;
import enlightenment.numeric.Scale;
import enlightenment.primitive.Primitive;
import enlightenment.world.parts.CancellationCheck;
import enlightenment.world.parts.CompiledPrimitives;
import java.util.Arrays;

/**
 * Whether a scene may have glass that keeps the direction of rays: thin slabs, interfaces of media of equal index, and faces of solids
 * inside a solid of higher priority. False only if there is certainly none.
 */
public final class StraightGlass {
    /** The margin by which boxes are widened, in units of the largest coordinate: more than the roundings of two surfaces together. */
    private static final double WIDENING = Scale.gamma(128);

    private final CompiledPrimitives compiled;
    private final boolean[] isGlassSolid;

    private StraightGlass(CompiledPrimitives compiled) {
        this.compiled = compiled;
        isGlassSolid = new boolean[compiled.primitives().length];
        for (int id : compiled.glassSolids()) {
            isGlassSolid[id] = true;
        }
    }

    /**
     * @param poll called regularly; what it throws ends this
     */
    public static boolean mayBeThere(CompiledPrimitives compiled, Accelerator accelerator, Runnable poll) {
        return hasPanes(compiled)
                || hasEqualIndices(compiled)
                || compiled.glassSolids().length > 1
                        && new StraightGlass(compiled).mayHaveHiddenFaces(accelerator, poll);
    }

    public static boolean hasPanes(CompiledPrimitives compiled) {
        for (int id = 0; id < compiled.primitives().length; id++) {
            Primitive p = compiled.primitives()[id];
            for (int face = 0; face < p.faceCount(); face++) {
                if (compiled.materials().of(id, face).isGlass && !p.isSolid()) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Whether there are two media of the same index of refraction, one of which may be empty space. */
    private static boolean hasEqualIndices(CompiledPrimitives compiled) {
        double[] indices = Arrays.stream(compiled.glassSolids())
                .mapToDouble(id -> compiled.materials().inside(id).indexOfRefraction)
                .sorted()
                .toArray();
        double last = 1;
        for (double index : indices) {
            if (index == last || index == 1) {
                return true;
            }
            last = index;
        }
        return false;
    }

    /** Whether a face of a solid of glass may lie within another solid that fills the place there. */
    private boolean mayHaveHiddenFaces(Accelerator accelerator, Runnable poll) {
        BvhQuery query =
                new BvhQuery(compiled.kind(), new long[compiled.kindNames().size()]);
        int[] solids = compiled.glassSolids();
        // Pairs of nested solids are compared.
        CancellationCheck work = new CancellationCheck(poll);
        for (int solid : solids) {
            work.step();
            Bounds box = widened(solid);
            query.clear();
            accelerator.overlapping(box, query);
            for (int k = 0; k < query.size(); k++) {
                work.step();
                int other = query.get(k);
                if (other != solid && isGlassSolid[other] && mayHide(box, solid, other)) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Whether the solid that fills overlaps of the two may contain a part of the other's surface. */
    private boolean mayHide(Bounds box, int id, int other) {
        if (!box.overlaps(compiled.primitives()[other].bounds())) {
            return false;
        }
        Primitive a = compiled.primitives()[id];
        Primitive b = compiled.primitives()[other];
        boolean isFirst = compiled.mediumRank()[id] < compiled.mediumRank()[other];
        double margin = WIDENING * Math.max(a.bounds().maxAbs(), b.bounds().maxAbs());
        return isFirst ? !Nesting.isWithin(a, b, margin) : !Nesting.isWithin(b, a, margin);
    }

    private Bounds widened(int id) {
        Bounds box = compiled.primitives()[id].bounds();
        return CoincidentSurfaces.widened(box, WIDENING * box.maxAbs());
    }
}
