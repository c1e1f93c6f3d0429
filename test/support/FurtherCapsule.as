package support
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Capsule;
    import starlogo.convex.ConvexShape;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * A capsule as a further convex structure of the engine: one class that the engine does not know. All its answers come from the package convex, so
     * they are compared with those of the engine's Capsule.
     */
    public final class FurtherCapsule extends BoundingStructure
    {
        private static const NONE:Vector.<int> = new Vector.<int>();
        private static const EDGES:Vector.<int> = new <int>[0, 3, 0, 0];

        /** The capsule that it is. */
        public var capsule:Capsule;

        private var _center:Vector3D = new Vector3D();
        private var _points:Vector.<Number> = new Vector.<Number>(6, true);

        public function FurtherCapsule(capsule:Capsule)
        {
            super(HULL);
            this.capsule = Capsule(capsule.clone());
        }

        override public function get volume():Number
        {
            return capsule.volume;
        }

        override public function place(placement:Placement, out:BoundingStructure = null):BoundingStructure
        {
            var placed:FurtherCapsule = out as FurtherCapsule;
            if (placed == null)
            {
                placed = newFor(out) as FurtherCapsule;
            }
            capsule.place(placement, placed.capsule);
            return placed;
        }

        override public function contains(point:Vector3D):Boolean
        {
            return capsule.contains(point);
        }

        override public function clone():BoundingStructure
        {
            return new FurtherCapsule(capsule);
        }

        override engine function widen(by:Number):void
        {
            capsule.widen(by);
        }

        override engine function widenForSurfaces():void
        {
            capsule.widenForSurfaces();
        }

        override engine function findPlacedBox(placement:Placement, out:Vector.<Number>):void
        {
            capsule.findPlacedBox(placement, out);
        }

        override engine function setShape(out:ConvexShape):void
        {
            _center.setTo((capsule.start.x + capsule.end.x) / 2, (capsule.start.y + capsule.end.y) / 2, (capsule.start.z + capsule.end.z) / 2);
            for (var i:int = 0; i < 6; i += 3)
            {
                var from:Vector3D = i == 0 ? capsule.start : capsule.end;
                _points[i] = from.x - _center.x;
                _points[i + 1] = from.y - _center.y;
                _points[i + 2] = from.z - _center.z;
            }
            out.setHull(_center, _points, NONE, EDGES);
            out.radius = capsule.radius;
        }
    }
}
