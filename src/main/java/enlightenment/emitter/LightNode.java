package enlightenment.emitter;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;

/** A node of a {@link LightTree} while {@link LightTreeBuilder} builds it, top down. Immutable. */
final class LightNode {
    final Bounds box;
    final NormalCone normals;
    final double strength;

    /** The index of its light; −1 for an inner node. */
    final int light;

    final LightNode first;
    final LightNode second;

    private LightNode(Bounds box, NormalCone normals, double strength, int light, LightNode first, LightNode second) {
        this.box = box;
        this.normals = normals;
        this.strength = strength;
        this.light = light;
        this.first = first;
        this.second = second;
    }

    /** A leaf with one light; without a normal it emits in all directions. */
    static LightNode leaf(Vec3 center, double radius, Vec3 normal, double strength, int light) {
        Bounds box = Bounds.around(center, new Vec3(radius, radius, radius));
        NormalCone cone = normal.maxAbs() > 0 ? new NormalCone(normal, 0) : NormalCone.ALL;
        return new LightNode(box, cone, strength, light, null, null);
    }

    /**
     * A leaf with one point light with a profile. The tree's bound falls with the cosine of the angle to the axis beyond the cone given
     * here, to 0 at 90° beyond it: so no direction of the profile has the bound 0.
     */
    static LightNode leaf(Vec3 center, IntensityProfile profile, double strength, int light) {
        double angle = Math.max(profile.coneAngle() - 0.5 * Math.PI, 0);
        NormalCone cone = new NormalCone(profile.axis(), Math.min(angle + NormalCone.SLACK, Math.PI));
        return new LightNode(Bounds.of(center), cone, strength, light, null, null);
    }

    /** A node of two children. */
    static LightNode of(LightNode first, LightNode second) {
        return new LightNode(
                first.box.union(second.box),
                first.normals.union(second.normals),
                first.strength + second.strength,
                -1,
                first,
                second);
    }

    /** Writes the numbers that {@link LightTree} reads. */
    void write(double[] data, int k) {
        Vec3 c = box.center();
        data[k] = c.x();
        data[k + 1] = c.y();
        data[k + 2] = c.z();
        data[k + 3] = 0.5 * box.extent().length() * (1 + Scale.gamma(16)) + Scale.gamma(16) * box.maxAbs();
        data[k + 4] = normals.axis().x();
        data[k + 5] = normals.axis().y();
        data[k + 6] = normals.axis().z();
        data[k + 7] = normals.angle() >= Math.PI ? -1 : StrictMath.cos(normals.angle());
        data[k + 8] = StrictMath.sin(normals.angle());
        data[k + 9] = strength;
    }
}
