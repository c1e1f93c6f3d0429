package away3d.entities
{
    import away3d.primitives.data.Segment;

    /** Lines. */
    public class SegmentSet extends Entity
    {
        public function SegmentSet()
        {
        }

        /** Adds a line. */
        public function addSegment(segment:Segment):void
        {
        }

        /** Takes all lines away. */
        public function removeAllSegments():void
        {
        }
    }
}
