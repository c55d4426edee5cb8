package enlightenment.shading;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.EyeProjection;
import enlightenment.compiled.PhysicalLight;
import enlightenment.compiled.SurfaceMaterial;
import enlightenment.frame.Basis;
import enlightenment.math.Vec3;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.primitive.SpherePrimitive;
import enlightenment.primitive.SupportSurface;
import java.util.ArrayList;
import java.util.List;

/**
 * Finds the images of lights that are smaller than a pixel: of the balls around lights, as they are seen straight, in flat mirrors, and in
 * mirrors that are spheres; glass reflects as mirrors do. Whether something hides them is not asked. Those in other mirrors, through glass, and of images are not found.
 */
final class SmallImages {
    /** Mirrors and lights are many in few scenes: so many pairs of them are looked at, the first ones. */
    private static final int MOST_PAIRS = 64;

    /** Corners of the polygon around a circle; and the circle's radius over that of the polygon, cos(π/8) = √(2 + √2)/2. */
    private static final int CORNERS = 8;

    private static final double INNER = Math.sqrt(2 + Math.sqrt(2)) / 2;

    /** The polygon around a mirrored ball's image. */
    private static final int MIRRORED_CORNERS = 4;

    private final CompiledScene scene;
    private final EyeProjection eye;
    private final Ray middle = new Ray();
    private final MirrorImage mirrorImage = new MirrorImage();
    private final Basis basis = new Basis();
    private final double[] corner = new double[3];
    private final List<SmallImage> found = new ArrayList<>();
    private int pairs;

    private SmallImages(CompiledScene scene) {
        this.scene = scene;
        eye = new EyeProjection(scene.camera);
        scene.camera.ray(0.5, 0.5, middle);
    }

    /** The small images in the picture of a scene of physical shading. */
    static SmallImage[] of(CompiledScene scene) {
        SmallImages images = new SmallImages(scene);
        PhysicalLight[] lights = scene.physical.lights;
        for (int light = 0; light < lights.length; light++) {
            if (images.canBeSeen(lights[light])) {
                images.addStraight(light);
            }
        }
        if (scene.physical.maxBounces > 0 && scene.physical.showsMirrored) {
            for (int id = 0; id < scene.primitives.length && images.pairs < MOST_PAIRS; id++) {
                images.addMirrored(id);
            }
        }
        return images.found.toArray(new SmallImage[0]);
    }

    private boolean canBeSeen(PhysicalLight l) {
        return !l.isPoint && !scene.coincident.concerns(l.id);
    }

    private void addStraight(int light) {
        PhysicalLight l = scene.physical.lights[light];
        addBall(light, SmallImage.STRAIGHT, SmallImage.ANY_FACE, new Vec3(l.ballX, l.ballY, l.ballZ), l.ballRadius);
    }

    private void addMirrored(int id) {
        Primitive p = scene.primitives[id];
        if (scene.coincident.concerns(id)) {
            return;
        }
        for (int face = 0; face < p.faceCount(); face++) {
            SurfaceMaterial m = scene.material(id, face);
            if (m.isDelta && !m.isBlack && (!m.isGlass || reflectsOutside(p, m))) {
                addMirrored(id, face);
            }
        }
    }

    /** Whether the outside of smooth glass reflects one share of the light at all wavelengths: a sample knows it. */
    private boolean reflectsOutside(Primitive p, SurfaceMaterial m) {
        return p.isSolid() && m.transparency == 1 && m.medium == null && !scene.physical.hasDispersion;
    }

    private void addMirrored(int id, int face) {
        PhysicalLight[] lights = scene.physical.lights;
        for (int light = 0; light < lights.length && pairs < MOST_PAIRS; light++) {
            PhysicalLight l = lights[light];
            if (!canBeSeen(l) || l.id == id) {
                continue;
            }
            if (scene.primitives[id] instanceof SpherePrimitive ball) {
                addInBall(id, ball, light);
                pairs++;
            } else if (scene.primitives[id].support(face) instanceof SupportSurface.Plane plane) {
                Vec3 normal = plane.unitNormal();
                Vec3 center = new Vec3(l.ballX, l.ballY, l.ballZ);
                double above = center.minus(plane.corners()[0]).dot(normal);
                addBall(light, id, face, center.minus(normal.times(2 * above)), l.ballRadius);
                pairs++;
            }
        }
    }

    /** Adds what a ball looks like: within an octagon around its outline. */
    private void addBall(int light, int mirror, int face, Vec3 center, double radius) {
        Vec3 axis = new Vec3(middle.dx, middle.dy, middle.dz);
        double size = radius / INNER;
        if (!eye.isParallel()) {
            axis = center.minus(new Vec3(middle.ox, middle.oy, middle.oz));
            double d = axis.length();
            if (!(d > radius)) {
                return;
            }
            size /= Math.sqrt((1 - radius / d) * (1 + radius / d));
        }
        axis = axis.normalized();
        basis.around(axis.x(), axis.y(), axis.z());
        double[] x = new double[CORNERS];
        double[] y = new double[CORNERS];
        for (int k = 0; k < CORNERS; k++) {
            double angle = 2 * Math.PI * k / CORNERS;
            double a = size * StrictMath.cos(angle);
            double b = size * StrictMath.sin(angle);
            corner[0] = center.x() + a * basis.ax + b * basis.bx;
            corner[1] = center.y() + a * basis.ay + b * basis.by;
            corner[2] = center.z() + a * basis.az + b * basis.bz;
            if (!place(x, y, k)) {
                return;
            }
        }
        keep(new SmallImage(light, mirror, face, x, y));
    }

    /** Parallel rays have no eye that a mirror's image could be sought from. */
    private void addInBall(int id, SpherePrimitive ball, int light) {
        PhysicalLight l = scene.physical.lights[light];
        if (eye.isParallel()
                || !mirrorImage.aim(
                        ball.x(),
                        ball.y(),
                        ball.z(),
                        ball.radius(),
                        l.ballX,
                        l.ballY,
                        l.ballZ,
                        l.ballRadius,
                        middle.ox,
                        middle.oy,
                        middle.oz)) {
            return;
        }
        double[] x = new double[MIRRORED_CORNERS];
        double[] y = new double[MIRRORED_CORNERS];
        for (int k = 0; k < MIRRORED_CORNERS; k++) {
            mirrorImage.corner(k, corner);
            corner[0] += middle.ox;
            corner[1] += middle.oy;
            corner[2] += middle.oz;
            if (!place(x, y, k)) {
                return;
            }
        }
        keep(new SmallImage(light, id, SmallImage.ANY_FACE, x, y));
    }

    private boolean place(double[] x, double[] y, int k) {
        boolean isBefore = eye.place(corner[0], corner[1], corner[2]);
        x[k] = eye.x * scene.camera.columns;
        y[k] = eye.y * scene.camera.rows;
        return isBefore;
    }

    private void keep(SmallImage image) {
        if (image.area() < 1 && image.reaches(0, 0, scene.camera.columns, scene.camera.rows)) {
            found.add(image);
        }
    }
}
