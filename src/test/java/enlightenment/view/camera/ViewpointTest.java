package enlightenment.view.camera;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.math.ExactPoint;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class ViewpointTest {
    /** Coordinates are rounded to 7 digits below the distance's first: 10 roundings are well below this share of it. */
    private static final double ROUNDED = 1e-6;

    private static Camera.Perspective perspective(Camera.Handedness handedness) {
        return new Camera.Perspective(
                ExactPoint.of("3", "1", "-4"),
                ExactPoint.of("1", "0.5", "2"),
                new Vec3(0, 2, 0),
                40,
                Camera.FieldOfViewAxis.VERTICAL,
                handedness,
                Optional.of(Camera.Lens.round(0.1, 5)));
    }

    private static Camera window() {
        return new Camera.Window(
                ExactPoint.of("0", "1", "-3"),
                ExactPoint.of("-3", "0", "0"),
                ExactPoint.of("-3", "3", "0"),
                ExactPoint.of("3", "3", "0"),
                ExactPoint.of("3", "0", "0"),
                0);
    }

    static Camera[] turning() {
        ExactPoint eye = ExactPoint.of("3", "1", "-4");
        ExactPoint to = ExactPoint.of("1", "0.5", "2");
        return new Camera[] {
            perspective(Camera.Handedness.LEFT),
            perspective(Camera.Handedness.RIGHT),
            new Camera.Orthographic(eye, to, Vec3.Y, 3),
            new Camera.Panorama(eye, to, Vec3.Y),
            window()
        };
    }

    private static Vec3 offset(Viewpoint v) {
        return v.camera().origin().minus(v.aim());
    }

    private static void assertNear(Vec3 expected, Vec3 actual, double size) {
        assertTrue(expected.minus(actual).length() <= ROUNDED * size, () -> expected + " expected, but " + actual);
    }

    @ParameterizedTest
    @MethodSource("turning")
    void anOrbitKeepsDistanceAndAim(Camera camera) {
        Viewpoint from = Viewpoint.of(camera);
        Viewpoint to = from.orbit(35, -20);
        assertEquals(from.aim(), to.aim());
        assertEquals(from.distance(), to.distance(), ROUNDED * from.distance());
        // The aim stays where it was in the picture: its components along the axes are the same.
        Vec3 before = offset(from);
        Vec3 after = offset(to);
        Pose a = Pose.of(from.camera());
        Pose b = Pose.of(to.camera());
        assertNear(
                new Vec3(before.dot(a.right()), before.dot(a.up()), before.dot(a.forward())),
                new Vec3(after.dot(b.right()), after.dot(b.up()), after.dot(b.forward())),
                from.distance());
    }

    @ParameterizedTest
    @MethodSource("turning")
    void anOrbitToTheRightMovesTheEyeToThePicturesRight(Camera camera) {
        Viewpoint from = Viewpoint.of(camera);
        Vec3 step = offset(from.orbit(1, 0)).minus(offset(from));
        assertTrue(step.dot(Pose.of(camera).right()) > 0.9 * step.length(), step.toString());
        Vec3 rise = offset(from.orbit(0, 1)).minus(offset(from));
        assertTrue(rise.dot(from.pole()) > 0, rise.toString());
    }

    @ParameterizedTest
    @MethodSource("turning")
    void anOrbitBackLeadsBack(Camera camera) {
        Viewpoint from = Viewpoint.of(camera);
        Viewpoint back = from.orbit(50, 25).orbit(0, -25).orbit(-50, 0);
        assertNear(offset(from), offset(back), 10 * from.distance());
        assertEquals(from.distance(), offset(from.orbit(360, 0)).length(), ROUNDED * from.distance());
    }

    @ParameterizedTest
    @ValueSource(doubles = {200, -200})
    void anOrbitEndsBeforeThePole(double up) {
        Viewpoint v = Viewpoint.of(perspective(Camera.Handedness.LEFT)).orbit(0, up);
        double angle = Rotations.between(offset(v), new Vec3(0, Math.signum(up), 0));
        assertEquals(1, angle, 1e-4);
        // It can still turn, and come back.
        assertEquals(
                45,
                Rotations.between(offset(v.orbit(10, -Math.signum(up) * 44)), new Vec3(0, Math.signum(up), 0)),
                1e-4);
    }

    @ParameterizedTest
    @EnumSource(Camera.Handedness.class)
    void whatIsAtTheAimFollowsThePointer(Camera.Handedness handedness) {
        Viewpoint from = Viewpoint.of(perspective(handedness));
        Viewpoint to = from.pan(0.25, 0.125, 1.5);
        Pose pose = Pose.of(from.camera());
        double height = 2 * from.distance() * Math.tan(Math.toRadians(20));
        // Seen from the new place, the old aim is a quarter of a height to the right of the middle, and an eighth below
        // it.
        Vec3 seen = from.aim().minus(to.aim());
        assertEquals(0.25 * height, seen.dot(pose.right()), ROUNDED * from.distance());
        assertEquals(-0.125 * height, seen.dot(pose.up()), ROUNDED * from.distance());
        assertNear(pose.forward(), Pose.of(to.camera()).forward(), 1);
        assertEquals(from.distance(), to.distance(), ROUNDED * from.distance());
    }

    @Test
    void aPanOfAWindowMovesAllOfIt() {
        Viewpoint from = Viewpoint.of(window()).aimedAt(ExactPoint.of("0", "1.5", "6"));
        Camera.Window to = (Camera.Window) from.pan(0.5, 0, 2).camera();
        // Three units high at three units of distance: nine units at the aim.
        assertEquals(ExactPoint.of("-4.5", "1", "-3"), to.eye());
        assertEquals(ExactPoint.of("-7.5", "0", "0"), to.lowerLeft());
        assertEquals(ExactPoint.of("-1.5", "3", "0"), to.upperRight());
    }

    @Test
    void theWidthMayBeWhatTheAngleSpans() {
        Camera.Perspective vertical = perspective(Camera.Handedness.LEFT);
        Viewpoint wide = Viewpoint.of(vertical.withAxis(Camera.FieldOfViewAxis.HORIZONTAL));
        Vec3 high = Viewpoint.of(vertical)
                .pan(1, 0, 2)
                .aim()
                .minus(Viewpoint.of(vertical).aim());
        Vec3 low = wide.pan(1, 0, 2).aim().minus(wide.aim());
        assertEquals(high.length() / 2, low.length(), ROUNDED * wide.distance());
        Viewpoint larger = Viewpoint.of(vertical.withAxis(Camera.FieldOfViewAxis.LARGER));
        assertEquals(low.length(), larger.pan(1, 0, 2).aim().minus(larger.aim()).length(), ROUNDED * wide.distance());
    }

    @ParameterizedTest
    @MethodSource("turning")
    void aDollyScalesTheDistance(Camera camera) {
        Viewpoint from = Viewpoint.of(camera);
        Viewpoint to = from.dolly(0.25);
        if (camera instanceof Camera.Orthographic c) {
            assertEquals(0.25 * c.height(), ((Camera.Orthographic) to.camera()).height());
        } else {
            assertNear(offset(from).times(0.25), offset(to), from.distance());
        }
        assertNear(Pose.of(camera).forward(), Pose.of(to.camera()).forward(), 1);
    }

    @ParameterizedTest
    @MethodSource("turning")
    void aRollTurnsTheUpperSideToTheLeft(Camera camera) {
        Viewpoint from = Viewpoint.of(camera);
        Pose before = Pose.of(camera);
        Pose after = Pose.of(from.roll(30).camera());
        assertNear(before.forward(), after.forward(), 1);
        assertNear(before.direction(-0.5, Math.sqrt(0.75), 0), after.up(), 1);
        assertNear(before.direction(Math.sqrt(0.75), 0.5, 0), after.right(), 1);
        assertEquals(camera.origin(), from.roll(30).camera().origin());
    }

    @Test
    void anIsometricViewIsPannedAndZoomedButNotTurned() {
        Viewpoint from = Viewpoint.of(new Camera.Isometric(ExactPoint.of("1", "2", "3"), 4));
        Camera.Isometric to = (Camera.Isometric) from.pan(0.5, 0.25, 1).dolly(2).camera();
        assertEquals(8, to.height());
        // x' = (x − z)·cos 30° and y' = y + (x + z)·sin 30° of what was in the middle, seen from the new one.
        Vec3 seen = ExactPoint.of("1", "2", "3").minus(to.lookAt());
        assertEquals(0.5 * 4, (seen.x() - seen.z()) * Math.sqrt(0.75), 4 * ROUNDED);
        assertEquals(-0.25 * 4, seen.y() + (seen.x() + seen.z()) / 2, 4 * ROUNDED);
        assertThrows(InvalidValueException.class, () -> from.orbit(1, 0));
        assertThrows(InvalidValueException.class, () -> from.roll(1));
    }

    @Test
    void theAngleOfViewStaysWithinLimits() {
        Viewpoint from = Viewpoint.of(perspective(Camera.Handedness.RIGHT));
        assertEquals(33.25, ((Camera.Perspective) from.withFieldOfView(33.25).camera()).fieldOfView());
        assertEquals(170, ((Camera.Perspective) from.withFieldOfView(360).camera()).fieldOfView());
        assertEquals(0.1, ((Camera.Perspective) from.withFieldOfView(0).camera()).fieldOfView());
        assertThrows(InvalidValueException.class, () -> Viewpoint.of(window()).withFieldOfView(40));
    }

    @Test
    void anAimIsAsFarAwayAsThePointAndInTheMiddleOfThePicture() {
        Viewpoint from = Viewpoint.of(perspective(Camera.Handedness.LEFT));
        Pose pose = Pose.of(from.camera());
        ExactPoint point = from.camera().origin().plus(pose.direction(0.5, -0.25, 3));
        Viewpoint to = from.aimedAt(point);
        assertNear(pose.forward().times(3), to.aim().minus(from.camera().origin()), 3);
        assertEquals(
                3,
                ((Camera.Perspective) from.focusedOn(point).camera())
                        .lens()
                        .get()
                        .focusDistance(),
                3 * ROUNDED);
        ExactPoint behind = from.camera().origin().plus(pose.direction(0, 0, -1));
        assertThrows(InvalidValueException.class, () -> from.aimedAt(behind));
    }

    /** Neither scale nor place have a part in it. */
    @Test
    void motionsAreTheSameInAnotherUnitAndFarAway() {
        ExactPoint far = ExactPoint.of("1e9", "-2e9", "3e9");
        Vec3 eye = new Vec3(3, 1, -4);
        Viewpoint near =
                Viewpoint.of(new Camera.Perspective(ExactPoint.ORIGIN.plus(eye), ExactPoint.ORIGIN, Vec3.Y, 40));
        Viewpoint tiny = Viewpoint.of(new Camera.Perspective(far.plus(eye.times(0x1p-30)), far, Vec3.Y, 40));
        Vec3 a = offset(near.orbit(30, 10).dolly(0.5));
        Vec3 b = offset(tiny.orbit(30, 10).dolly(0.5)).times(0x1p30);
        assertNear(a, b, near.distance());
    }
}
