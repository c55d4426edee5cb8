package enlightenment.emitter;

/** The sides of a surface from which a light emits; the front is the side of its normal. */
public enum LightSides {
    FRONT,
    BOTH,
    BACK;

    /** The front, or both sides. */
    static LightSides of(boolean twoSided) {
        return twoSided ? BOTH : FRONT;
    }

    /** Whether light leaves at this cosine with the normal. */
    boolean shineAt(double cosine) {
        return switch (this) {
            case FRONT -> cosine > 0;
            case BOTH -> cosine != 0;
            case BACK -> cosine < 0;
        };
    }
}
