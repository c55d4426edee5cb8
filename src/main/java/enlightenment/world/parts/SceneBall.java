package enlightenment.world.parts;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import enlightenment.primitive.Primitive;

/** The bounding ball of all surfaces of a scene, through which light from infinity passes. */
public record SceneBall(Vec3 center, double radius) {
    public static SceneBall around(Primitive[] primitives) {
        Bounds box = null;
        for (Primitive p : primitives) {
            box = box == null ? p.bounds() : box.union(p.bounds());
        }
        return box == null
                ? new SceneBall(Vec3.ZERO, 0)
                : new SceneBall(box.center(), box.extent().length() / 2 * (1 + Scale.gamma(8)));
    }
}
