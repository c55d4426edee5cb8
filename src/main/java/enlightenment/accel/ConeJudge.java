package enlightenment.accel;

/** Returns verdicts on primitives for the segments from a cone's apex to its ball. */
public interface ConeJudge {
    /** The primitive certainly blocks every segment. */
    int BLOCKS_ALL = -1;

    /** The primitive certainly blocks no segment. */
    int CLEAR = 0;

    /** The primitive may block some segments. */
    int MAY_BLOCK = 1;

    /** The verdict on the primitive with an id: {@link #BLOCKS_ALL}, {@link #CLEAR} or {@link #MAY_BLOCK}. */
    int judge(int id);
}
