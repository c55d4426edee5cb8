package enlightenment.camera;

/**
 * The orientation of the coordinates that a view was made for: which way the picture's right side points. The other one shows the mirror
 * image of the scene.
 */
public enum Handedness {
    /** The picture's right is up × forward: x to the right, y up and z away from the viewer. */
    LEFT,

    /** The picture's right is forward × up: x to the right, y up and z towards the viewer. */
    RIGHT
}
