package enlightenment.accel;

/** Says what a primitive is to the segments from a cone's apex to its ball. */
public interface ConeJudge {
    /** It certainly blocks every segment. */
    int BLOCKS_ALL = -1;

    /** It certainly blocks none. */
    int CLEAR = 0;

    /** It may block some. */
    int MAY_BLOCK = 1;

    /** The verdict on the primitive with an id: {@link #BLOCKS_ALL}, {@link #CLEAR} or {@link #MAY_BLOCK}. */
    int judge(int id);
}
