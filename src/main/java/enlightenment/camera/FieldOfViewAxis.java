package enlightenment.camera;

/** The side of the picture that a field of view spans; the other side follows from the aspect ratio. */
public enum FieldOfViewAxis {
    /** The picture's height. */
    VERTICAL,

    /** The picture's width. */
    HORIZONTAL,

    /** The shorter of width and height. */
    SMALLER,

    /** The longer of width and height. */
    LARGER;

    /**
     * Whether the field of view spans the width of a picture.
     *
     * @param width of the picture in pixels, at least 1
     * @param height of the picture in pixels, at least 1
     */
    public boolean spansWidth(int width, int height) {
        return switch (this) {
            case VERTICAL -> false;
            case HORIZONTAL -> true;
            case SMALLER -> width < height;
            case LARGER -> width > height;
        };
    }
}
