package starlogo.collision
{
    /** Every agent is a sphere of its size, whatever its model (thesis §2.2). */
    internal final class UnitSphereStrategy extends ShapeStrategy
    {
        /** Without settings. */
        public function UnitSphereStrategy()
        {
        }

        /** @inheritDoc */
        override public function bindModel(shape:WorldShape):void
        {
            shape.isSphere = true;
        }

        /** @inheritDoc */
        override public function updateWorldShape(shape:WorldShape):void
        {
            var radius:Number = 0.5 * shape.placement.size;
            shape.offsetZ = radius;
            shape.halfX = shape.halfY = shape.halfZ = shape.radius = radius;
        }
    }
}
