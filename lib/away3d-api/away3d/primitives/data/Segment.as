package away3d.primitives.data
{
    import flash.geom.Vector3D;

    /** A part of a SegmentSet. */
    public class Segment
    {
        public function Segment(start:Vector3D, end:Vector3D, anchor:Vector3D, colorStart:uint = 0x333333, colorEnd:uint = 0x333333, thickness:Number = 1)
        {
        }
    }
}
