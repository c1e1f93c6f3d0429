package starlogo.search
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * A sphere and a capsule around a structure. A collider tests them first, because their tests are cheaper (thesis §7.5). They contain the
     * structure, not only the model, so they never decide otherwise than the structure itself.
     *
     * @private
     */
    public final class OuterStructures
    {
        internal var sphere:Sphere;
        internal var capsule:Capsule;

        /** @param structure a box or a capsule */
        public function OuterStructures(structure:BoundingStructure)
        {
            capsule = structure is Box ? aroundBox(Box(structure)) : structure.clone() as Capsule;
            var half:Vector3D = capsule.end.subtract(capsule.start);
            half.scaleBy(0.5);
            sphere = new Sphere(capsule.start.add(half), half.length + capsule.radius);
            if (structure is Box)
            {
                var box:Box = Box(structure);
                sphere.radius = Math.sqrt(box.halfX * box.halfX + box.halfY * box.halfY + box.halfZ * box.halfZ);
            }
            sphere.radius *= Tolerances.OUTER;
            capsule.radius *= Tolerances.OUTER;
        }

        /** Sets both to a model's sphere and capsule, placed where an agent is and wider by a margin. */
        public function place(model:OuterStructures, placement:Placement, margin:Number):void
        {
            model.sphere.place(placement, sphere);
            sphere.widen(margin);
            model.capsule.place(placement, capsule);
            capsule.widen(margin);
        }

        // Around the box's longest axis, through all corners.
        private static function aroundBox(box:Box):Capsule
        {
            var longest:Number = Math.max(Math.max(box.halfX, box.halfY), box.halfZ);
            var axis:Vector3D = longest == box.halfY ? box.axisY : box.axisZ;
            if (longest == box.halfX)
            {
                axis = box.axisX;
            }
            var along:Vector3D = axis.clone();
            along.scaleBy(longest);
            var across:Number = box.halfX * box.halfX + box.halfY * box.halfY + box.halfZ * box.halfZ - longest * longest;
            return new Capsule(box.center.subtract(along), box.center.add(along), Math.sqrt(Math.max(0, across)));
        }
    }
}
