package enlightenment.importer.support;

import enlightenment.math.Vec3;
import enlightenment.mesh.MeshBuilder;
import enlightenment.mesh.TriangleMesh;
import java.util.List;

/** Shapes of unit size as triangles, with normals and with the texture coordinates that pbrt and Mitsuba give them. */
final class ShapeMeshes {
    /** Around a ball, disk or cylinder. */
    private static final int AROUND = 128;

    /** From pole to pole of a ball. */
    private static final int RINGS = 64;

    /** The ball of radius 1: u around z from +x, v from −z to +z. */
    static final TriangleMesh SPHERE = sphere();

    /** The disk of radius 1 that faces +z: u from the middle outwards, v around from +x. */
    static final TriangleMesh DISK = disk();

    /** {@link #DISK} whose texture has its upper edge at v = 0. */
    static final TriangleMesh DISK_DOWN = VFlip.flipped(DISK);

    /** The cylinder of radius 1 from z = 0 to 1, without caps: u around from +x, v upwards. */
    static final TriangleMesh CYLINDER = cylinder();

    /** {@link #CYLINDER} whose texture has its upper edge at v = 0. */
    static final TriangleMesh CYLINDER_DOWN = VFlip.flipped(CYLINDER);

    /** The faces of the cube −1..1, with the directions of Mitsuba's textures. */
    static final List<CubeFace> CUBE_FACES = List.of(
            new CubeFace(Vec3.Y.negated(), Vec3.Z, Vec3.X.negated()),
            new CubeFace(Vec3.Y, Vec3.X.negated(), Vec3.Z),
            new CubeFace(Vec3.X, Vec3.Y, Vec3.Z),
            new CubeFace(Vec3.Z, Vec3.Y, Vec3.X.negated()),
            new CubeFace(Vec3.X.negated(), Vec3.Y, Vec3.Z.negated()),
            new CubeFace(Vec3.Z.negated(), Vec3.Y.negated(), Vec3.X.negated()));

    /** The cube −1..1, flat. */
    static final TriangleMesh CUBE = cube();

    /**
     * A face of the cube.
     *
     * @param out its middle, which is its normal
     * @param right to the right in its texture
     * @param up upwards in its texture; right × up points outwards
     */
    record CubeFace(Vec3 out, Vec3 right, Vec3 up) {}

    private ShapeMeshes() {}

    private static double cos(int i) {
        return i % AROUND == 0 ? 1 : StrictMath.cos(2 * StrictMath.PI * i / AROUND);
    }

    private static double sin(int i) {
        return i % AROUND == 0 ? 0 : StrictMath.sin(2 * StrictMath.PI * i / AROUND);
    }

    private static TriangleMesh sphere() {
        MeshBuilder mesh = new MeshBuilder();
        for (int ring = 0; ring <= RINGS; ring++) {
            double angle = StrictMath.PI * ring / RINGS;
            double radius = ring == 0 || ring == RINGS ? 0 : StrictMath.sin(angle);
            float z = (float) (ring == 0 ? 1 : ring == RINGS ? -1 : StrictMath.cos(angle));
            for (int i = 0; i <= AROUND; i++) {
                // Adding 0 makes a 0 of −0: poles are one place.
                float x = (float) (radius * cos(i) + 0.0);
                float y = (float) (radius * sin(i) + 0.0);
                mesh.vertex(x, y, z);
                mesh.normal(x, y, z);
                mesh.uv((double) i / AROUND, 1 - (double) ring / RINGS);
            }
        }
        grid(mesh, RINGS, true);
        return mesh.build();
    }

    /** Joins rows of AROUND + 1 vertices each; the first row is the upper one. */
    private static void grid(MeshBuilder mesh, int rows, boolean hasPoles) {
        for (int row = 0; row < rows; row++) {
            for (int i = 0; i < AROUND; i++) {
                int a = row * (AROUND + 1) + i;
                int below = a + AROUND + 1;
                if (!hasPoles || row < rows - 1) {
                    mesh.triangle(a, below, below + 1);
                }
                if (!hasPoles || row > 0) {
                    mesh.triangle(a, below + 1, a + 1);
                }
            }
        }
    }

    private static TriangleMesh disk() {
        MeshBuilder mesh = new MeshBuilder();
        for (int i = 0; i <= AROUND; i++) {
            mesh.vertex((float) cos(i), (float) sin(i), 0);
            mesh.normal(0, 0, 1);
            mesh.uv(1, (double) i / AROUND);
        }
        for (int i = 0; i < AROUND; i++) {
            int middle = mesh.vertex(0, 0, 0);
            mesh.normal(0, 0, 1);
            mesh.uv(0, (i + 0.5) / AROUND);
            mesh.triangle(middle, i, i + 1);
        }
        return mesh.build();
    }

    private static TriangleMesh cylinder() {
        MeshBuilder mesh = new MeshBuilder();
        for (int row = 0; row < 2; row++) {
            for (int i = 0; i <= AROUND; i++) {
                mesh.vertex((float) cos(i), (float) sin(i), 1 - row);
                mesh.normal(cos(i), sin(i), 0);
                mesh.uv((double) i / AROUND, 1 - row);
            }
        }
        grid(mesh, 1, false);
        return mesh.build();
    }

    private static TriangleMesh cube() {
        MeshBuilder mesh = new MeshBuilder();
        for (CubeFace f : CUBE_FACES) {
            int first = mesh.vertices();
            for (int i = 0; i < 4; i++) {
                double r = i == 1 || i == 2 ? 1 : -1;
                double u = i >= 2 ? 1 : -1;
                Vec3 p = f.out().plus(f.right().times(r)).plus(f.up().times(u));
                mesh.vertex(p.x(), p.y(), p.z());
                mesh.uv((r + 1) / 2, (u + 1) / 2);
            }
            mesh.triangle(first, first + 1, first + 2);
            mesh.triangle(first, first + 2, first + 3);
        }
        return mesh.build();
    }
}
