package enlightenment.transport.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.Vec3;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Images of balls in spheres, against lines that are followed one by one. */
class MirrorImageTest {
    private static final int CASES = 2000;
    private static final int LINES = 2000;

    private final SplittableRandom random = new SplittableRandom(7);

    private Vec3 direction() {
        double z = 2 * random.nextDouble() - 1;
        double turn = 2 * Math.PI * random.nextDouble();
        double s = Math.sqrt(1 - z * z);
        return new Vec3(s * StrictMath.cos(turn), s * StrictMath.sin(turn), z);
    }

    private double between(double low, double high) {
        return low * StrictMath.pow(high / low, random.nextDouble());
    }

    /** A point, a ball, and its image in the unit sphere around the origin. */
    private final class Case {
        final Vec3 eye;
        final Vec3 ball;
        final double radius;
        final MirrorImage image = new MirrorImage();
        final boolean exists;

        Case() {
            eye = direction().times(1 + between(0.02, 20));
            double height = between(0.05, 20);
            ball = direction().times(1 + height);
            radius = Math.min(between(0.002, 3), 0.999 * height);
            exists = image.aim(0, 0, 0, 1, ball.x(), ball.y(), ball.z(), radius, eye.x(), eye.y(), eye.z());
        }

        /** Whether the sphere reflects a line from the eye into the ball. */
        boolean reflects(Vec3 d) {
            double b = -eye.dot(d);
            double discriminant = b * b - (eye.dot(eye) - 1);
            if (!(discriminant >= 0) || b < 0) {
                return false;
            }
            Vec3 p = eye.plus(d.times(b - Math.sqrt(discriminant)));
            Vec3 n = p.times(1 / p.length());
            Vec3 r = d.minus(n.times(2 * d.dot(n)));
            Vec3 q = ball.minus(p);
            double along = q.dot(r);
            return along > 0 && q.dot(q) - along * along < radius * radius;
        }

        /** A direction to the sphere. */
        Vec3 toSphere() {
            Vec3 on = direction();
            Vec3 d = on.minus(eye);
            return d.times(1 / d.length());
        }
    }

    @Test
    void allLinesThatAreReflectedIntoTheBallLieInItsImage() {
        int lit = 0;
        int outside = 0;
        for (int k = 0; k < CASES; k++) {
            Case c = new Case();
            for (int i = 0; i < LINES; i++) {
                Vec3 d = c.toSphere();
                if (c.reflects(d)) {
                    lit++;
                    outside += c.exists && c.image.contains(d.x(), d.y(), d.z()) ? 0 : 1;
                }
            }
        }
        assertTrue(lit > 10_000, "lines: " + lit);
        int found = lit;
        int lost = outside;
        assertTrue(outside <= 1e-3 * lit, () -> lost + " of " + found);
    }

    @Test
    void muchOfAnImageIsTheBall() {
        double share = 0;
        int images = 0;
        for (int k = 0; k < CASES; k++) {
            Case c = new Case();
            if (!c.exists || c.ball.minus(c.eye).length() < c.radius) {
                continue;
            }
            images++;
            for (int i = 0; i < 100; i++) {
                c.image.sample(random.nextDouble(), random.nextDouble());
                share += c.reflects(new Vec3(c.image.dx, c.image.dy, c.image.dz)) ? 0.01 : 0;
            }
        }
        double mean = share / images;
        assertTrue(mean > 0.6, () -> "share " + mean);
    }

    @Test
    void whatIsSampledLiesInTheImageEvenly() {
        Case c = new Case();
        while (!c.exists) {
            c = new Case();
        }
        int n = 20_000;
        for (int i = 0; i < n; i++) {
            c.image.sample(random.nextDouble(), random.nextDouble());
            assertTrue(c.image.contains(c.image.dx, c.image.dy, c.image.dz));
            assertEquals(1, new Vec3(c.image.dx, c.image.dy, c.image.dz).length(), 1e-12);
        }
        int found = 0;
        int tries = 1_000_000;
        for (int i = 0; i < tries; i++) {
            Vec3 d = direction();
            found += c.image.contains(d.x(), d.y(), d.z()) ? 1 : 0;
        }
        double mean = 1 / (4 * Math.PI * c.image.pdf);
        assertEquals(mean, found / (double) tries, 5 * Math.sqrt(mean / tries));
    }

    @Test
    void aBallBehindTheMirrorHasNoImage() {
        MirrorImage image = new MirrorImage();
        assertFalse(image.aim(0, 0, 0, 1, -5, 0, 0, 0.5, 3, 0, 0));
        assertEquals(0, image.pdf);
        assertTrue(image.aim(0, 0, 0, 1, 5, 0, 0, 0.5, 3, 0, 0));
    }

    @Test
    void thereIsNoImageFromWithinTheMirror() {
        assertFalse(new MirrorImage().aim(0, 0, 0, 1, 0, 5, 0, 0.5, 0.2, 0, 0));
        assertFalse(new MirrorImage().aim(0, 0, 0, 1, 0, 0.5, 0, 0.1, 3, 0, 0));
    }
}
