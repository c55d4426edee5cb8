package enlightenment.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.DisplayRgb;
import enlightenment.frame.Rotation;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Transform;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PlacedObjectTest {
    private static final List<Material> SIX = IntStream.range(0, 6)
            .mapToObj(i -> (Material) Material.Matte.of(Texture.of(DisplayRgb.ofBytes(i, i, i))))
            .toList();

    /** The outward normal of a face of a cube. */
    private static Vec3 normal(Cube cube, int face) {
        Vec3 axis = Rotation.ofDegrees(cube.rotation()).axis(face / 2);
        return face % 2 == 0 ? axis.times(-1) : axis;
    }

    /** A face goes where the transform takes its normal, also in a mirror. */
    @ParameterizedTest
    @ValueSource(ints = {1, -1})
    void theFacesOfACubeKeepTheirMaterials(int sign) {
        Transform transform = Transform.of(
                new Transform.Scale(new Vec3(2 * sign, 2, 2)),
                new Transform.Rotate(new Vec3(20, -70, 110)),
                new Transform.Translate(ExactPoint.of(1, 2, 3)));
        SceneObject die =
                new SceneObject("die", new Cube(ExactPoint.of(1, 0, 0), 1, new Vec3(10, 20, 30)), SIX.get(0), SIX);
        SceneObject placed = die.placed(transform, "");
        Cube before = (Cube) die.shape();
        Cube after = (Cube) placed.shape();
        assertEquals(2, after.radius(), 1e-15);
        for (int face = 0; face < 6; face++) {
            Vec3 expected = transform.applyLinear(normal(before, face)).normalized();
            for (int other = 0; other < 6; other++) {
                double cosine = normal(after, other).dot(expected);
                assertTrue(Math.abs(cosine) < 1e-12 || Math.abs(Math.abs(cosine) - 1) < 1e-12, "" + cosine);
                if (cosine > 0.5) {
                    assertEquals(die.materialOf(face), placed.materialOf(other));
                }
            }
        }
    }

    /** Squares of such scales are no doubles. */
    @ParameterizedTest
    @ValueSource(ints = {-900, 900})
    void theUnitOfLengthDoesNotMatter(int exponent) {
        double scale = Math.scalb(1.0, exponent);
        Sphere ball = Sphere.of(ExactPoint.ORIGIN, 1);
        Transform alike = Transform.of(new Transform.Scale(new Vec3(scale, -scale, scale)));
        assertEquals(scale, ((Sphere) ball.placed(alike)).radius());
        assertTrue(alike.isMirror());
        Transform stretched = Transform.of(new Transform.Scale(new Vec3(scale, scale, 2 * scale)));
        assertThrows(InvalidValueException.class, () -> ball.placed(stretched));
    }

    @Test
    void aTransformOfNoVolumeIsRefused() {
        assertThrows(
                InvalidValueException.class,
                () -> new Transform.Matrix(Vec3.X, Vec3.Y, new Vec3(1, 1, 0), ExactPoint.ORIGIN));
        assertThrows(InvalidValueException.class, () -> new Transform.Scale(new Vec3(1, 0, 1)));
    }
}
