package enlightenment.primitive;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.frame.Bounds;
import enlightenment.frame.Rotation;
import enlightenment.math.Vec3;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The volumes of solids, by counting points. */
class VolumeTest {
    private static final Vec3 HERE = new Vec3(0.3, -0.2, 0.9);
    private static final Vec3 THERE = new Vec3(1.1, 0.4, 0.5);

    static Stream<Primitive> solids() {
        return Stream.of(
                new SpherePrimitive(HERE, 1.3, Vec3.Z),
                new BoxPrimitive(HERE, new Vec3(0.7, 1.9, 1.1)),
                new CubePrimitive(HERE, 0.4, Rotation.ofDegrees(new Vec3(20, 30, 40))),
                new CylinderPrimitive(HERE, THERE, 0.6, true),
                new ConePrimitive(HERE, THERE, 0.8, 0, true),
                new ConePrimitive(HERE, THERE, 0.3, 0.9, true),
                new TorusPrimitive(HERE, THERE.normalized(), 1.1, 0.4));
    }

    @ParameterizedTest
    @MethodSource("solids")
    void asManyPointsOfTheBoxAreInsideAsTheVolumeSays(Primitive solid) {
        SplittableRandom random = new SplittableRandom(5);
        Bounds box = solid.bounds();
        Vec3 extent = box.extent();
        Vec3 least = box.center().minus(extent.times(0.5));
        int points = 100_000;
        int inside = 0;
        for (int k = 0; k < points; k++) {
            double x = Math.fma(random.nextDouble(), extent.x(), least.x());
            double y = Math.fma(random.nextDouble(), extent.y(), least.y());
            double z = Math.fma(random.nextDouble(), extent.z(), least.z());
            inside += solid.contains(x, y, z) ? 1 : 0;
        }
        double share = solid.volume() / (extent.x() * extent.y() * extent.z());
        assertEquals(share, (double) inside / points, 4.5 * Math.sqrt(share * (1 - share) / points) + 1e-12);
    }

    @Test
    void whatIsOpenEnclosesNothing() {
        assertEquals(0, new CylinderPrimitive(HERE, THERE, 0.6, false).volume());
        assertEquals(0, new ConePrimitive(HERE, THERE, 0.6, 0.3, false).volume());
    }
}
