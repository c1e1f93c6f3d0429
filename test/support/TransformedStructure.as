package support
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Hull;
    import starlogo.bounding.Sphere;

    /**
     * A structure put through an agent's transform as the thesis says it (§3.5): scaled, then turned about one axis of the world
     * after the other, then moved. Shares nothing with the engine's way, which multiplies the turns first.
     */
    public final class TransformedStructure
    {
        /** A structure of a model, in the world. */
        public static function of(structure:BoundingStructure, agent:Agent):BoundingStructure
        {
            var size:Number = agent.size;
            if (structure is Sphere)
            {
                return new Sphere(point(Sphere(structure).center, agent), Sphere(structure).radius * size);
            }
            if (structure is Capsule)
            {
                var capsule:Capsule = Capsule(structure);
                return new Capsule(point(capsule.start, agent), point(capsule.end, agent), capsule.radius * size);
            }
            if (structure is Hull)
            {
                var corners:Vector.<Number> = Hull(structure).corners;
                for (var i:int = 0; i < corners.length; i += 3)
                {
                    var corner:Vector3D = point(new Vector3D(corners[i], corners[i + 1], corners[i + 2]), agent);
                    corners[i] = corner.x;
                    corners[i + 1] = corner.y;
                    corners[i + 2] = corner.z;
                }
                return new Hull(corners);
            }
            var box:Box = Box(structure);
            return new Box(point(box.center, agent), turned(box.axisX, agent), turned(box.axisY, agent), turned(box.axisZ, agent), box.halfX * size, box.halfY * size, box.halfZ * size);
        }

        private static function point(at:Vector3D, agent:Agent):Vector3D
        {
            var scaled:Vector3D = at.clone();
            scaled.scaleBy(agent.size);
            return turned(scaled, agent).add(new Vector3D(agent.x, agent.y, agent.z));
        }

        private static function turned(v:Vector3D, agent:Agent):Vector3D
        {
            var cos:Number = cosine(agent.roll);
            var sin:Number = cosine(agent.roll - 90);
            v = new Vector3D(v.x, cos * v.y - sin * v.z, sin * v.y + cos * v.z);
            cos = cosine(agent.pitch);
            sin = cosine(agent.pitch - 90);
            v = new Vector3D(cos * v.x + sin * v.z, v.y, cos * v.z - sin * v.x);
            cos = cosine(agent.heading);
            sin = cosine(agent.heading - 90);
            return new Vector3D(cos * v.x - sin * v.y, sin * v.x + cos * v.y, v.z);
        }

        // Exact for quarter turns: structures that touch exactly are among the cases.
        private static function cosine(degrees:Number):Number
        {
            if (degrees % 90 == 0)
            {
                return [1, 0, -1, 0][(degrees / 90 % 4 + 4) % 4];
            }
            return Math.cos(degrees / 180 * Math.PI);
        }
    }
}
