package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.linear;

import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Shape;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import java.util.Random;

/** Blocks of all materials on a coarse grid, so that faces of theirs lie in one another in all ways there are. */
final class RandomBlocks {
    final Random random;

    RandomBlocks(long seed) {
        random = new Random(seed);
    }

    /** One of so many multiples of a half. */
    double grid(int from, int steps) {
        return 0.5 * (from + random.nextInt(steps));
    }

    /** A material that absorbs nothing. */
    Material material() {
        int priority = random.nextInt(3) == 0 ? 1 : 0;
        return switch (random.nextInt(8)) {
            case 0 -> Material.Matte.of(linear(1, 1, 1)).withRoughness(random.nextBoolean() ? 0 : 0.8);
            case 1 -> Material.Mirror.of(linear(1, 1, 1));
            case 2 -> glass(random.nextBoolean() ? 1.5 : 1.3, 0, priority);
            case 3 -> glass(1.5, 0.5, priority);
            case 4 -> glass(1, 0, priority);
            case 5 -> fog(1, 0, priority);
            case 6 -> fog(1.4, random.nextBoolean() ? 0 : 0.4, priority);
            default -> Glossy.of(linear(1, 1, 1), 0.5);
        };
    }

    private static Material glass(double index, double roughness, int priority) {
        return new Glass(linear(1, 1, 1), index, 1, priority, true).withRoughness(roughness);
    }

    private static Material fog(double index, double roughness, int priority) {
        return new Material.Scattering(Medium.Coefficients.of(Rgb.gray(1), Rgb.BLACK), index, roughness, priority);
    }

    Shape shape() {
        double y = grid(0, 2);
        if (random.nextInt(3) == 0) {
            return new Cylinder(at(0, y, 0), at(0, y + grid(1, 2), 0), grid(1, 2), true);
        }
        double x = grid(-2, 4);
        double z = grid(-2, 4);
        return new Box(at(x, y, z), at(x + grid(1, 3), y + grid(1, 2), z + grid(1, 3)));
    }
}
