package starlogo.models.scene
{
    /**
     * How much each point of a skin follows which joints, in a file of any format. A point follows each of its influences: a joint, by a weight. The
     * lists have the influences of all points, one point after the other. The readers of formats fill them.
     *
     * @private
     */
    public final class JointInfluences
    {
        /** The first influence of each point, and one entry more: the number of influences. */
        public var offsets:Vector.<int> = new <int>[0];

        /** The index of each influence's joint. */
        public var joints:Vector.<int> = new Vector.<int>();

        /** The weight of each influence. */
        public var weights:Vector.<Number> = new Vector.<Number>();
    }
}
