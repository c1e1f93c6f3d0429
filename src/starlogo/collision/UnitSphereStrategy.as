package starlogo.collision
{
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

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
            var placement:Placement = shape.agent.placement;
            var radius:Number = 0.5 * placement.size;
            shape.x = placement.x;
            shape.y = placement.y;
            shape.z = placement.z + radius;
            shape.halfX = shape.halfY = shape.halfZ = shape.radius = radius;
        }
    }
}
