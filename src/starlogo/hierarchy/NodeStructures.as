package starlogo.hierarchy
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;

    use namespace engine;

    /**
     * Gives the nodes of a hierarchy spheres or capsules in place of boxes (thesis §7.7). Also gives each node a cover: a structure that
     * encloses the structures of all its descendants.
     */
    internal final class NodeStructures
    {
        private var _kind:int;
        private var _items:Items;
        private var _margin:Number;

        /**
         * @param kind BoundingStructure.SPHERE or CAPSULE
         * @param items the items of the nodes
         * @param margin how much larger than its part a structure is
         */
        public function NodeStructures(kind:int, items:Items, margin:Number)
        {
            _kind = kind;
            _items = items;
            _margin = margin;
        }

        /** Gives a node its structure. */
        public function enclose(node:HierarchyNode):void
        {
            var points:Vector.<Number> = _items.cornersOf(node.first, node.end);
            if (_kind == BoundingStructure.SPHERE)
            {
                node.structure = sphereAround(node, points);
            }
            else
            {
                node.structure = capsuleAround(node, points);
            }
        }

        /** Gives a node with children its cover: its structure, enlarged. The children must have their covers already. */
        public function cover(node:HierarchyNode):void
        {
            if (_kind == BoundingStructure.SPHERE)
            {
                var sphere:Sphere = Sphere(node.structure.clone());
                sphere.radius = Math.max(sphere.radius, reachOf(node.low, sphere.center, sphere.center),
                        reachOf(node.high, sphere.center, sphere.center)) + _margin;
                node.cover = sphere;
                return;
            }
            var capsule:Capsule = Capsule(node.structure.clone());
            capsule.radius = Math.max(capsule.radius, reachOf(node.low, capsule.start, capsule.end),
                    reachOf(node.high, capsule.start, capsule.end)) + _margin;
            node.cover = capsule;
        }

        // The largest distance of a point of a child's cover from a segment. It is found at the ends of the cover's own segment.
        private function reachOf(child:HierarchyNode, start:Vector3D, end:Vector3D):Number
        {
            var structure:BoundingStructure = child.cover == null ? child.structure : child.cover;
            if (_kind == BoundingStructure.SPHERE)
            {
                return distance(Sphere(structure).center, start, end) + Sphere(structure).radius;
            }
            var capsule:Capsule = Capsule(structure);
            return Math.max(distance(capsule.start, start, end), distance(capsule.end, start, end)) + capsule.radius;
        }

        private static function distance(point:Vector3D, start:Vector3D, end:Vector3D):Number
        {
            var along:Vector3D = end.subtract(start);
            var offset:Vector3D = point.subtract(start);
            var t:Number = along.lengthSquared > 0 ? offset.dotProduct(along) / along.lengthSquared : 0;
            along.scaleBy(Math.max(0, Math.min(1, t)));
            return offset.subtract(along).length;
        }

        private function sphereAround(node:HierarchyNode, points:Vector.<Number>):Sphere
        {
            var largest:Number = 0;
            for (var i:int = 0; i < points.length; i += 3)
            {
                var x:Number = points[i] - node.x;
                var y:Number = points[i + 1] - node.y;
                var z:Number = points[i + 2] - node.z;
                var squared:Number = x * x + y * y + z * z;
                largest = squared > largest ? squared : largest;
            }
            return new Sphere(new Vector3D(node.x, node.y, node.z), Math.sqrt(largest) + _margin);
        }

        // The capsule is along the box's longest axis. Its radius is the distance of the farthest vertex from that axis, and it is just
        // long enough to enclose the other vertices.
        private function capsuleAround(node:HierarchyNode, points:Vector.<Number>):Capsule
        {
            var axis:int = node.longestAxis();
            var centre:Vector.<Number> = new <Number>[node.x, node.y, node.z];
            var u:int = (axis + 1) % 3;
            var v:int = (axis + 2) % 3;
            var distances:Vector.<Number> = new Vector.<Number>(points.length / 3, true);
            var largest:Number = 0;
            for (var i:int = 0; i < distances.length; i++)
            {
                var du:Number = points[3 * i + u] - centre[u];
                var dv:Number = points[3 * i + v] - centre[v];
                distances[i] = du * du + dv * dv;
                largest = Math.max(largest, distances[i]);
            }
            var low:Number = Infinity;
            var high:Number = -Infinity;
            for (i = 0; i < distances.length; i++)
            {
                // How far from the segment's end the vertex may be along the axis.
                var slack:Number = Math.sqrt(largest - distances[i]);
                low = Math.min(low, points[3 * i + axis] + slack);
                high = Math.max(high, points[3 * i + axis] - slack);
            }
            if (low > high)
            {
                low = high = (low + high) / 2;
            }
            var start:Vector3D = pointOnAxis(centre, axis, low);
            var end:Vector3D = pointOnAxis(centre, axis, high);
            return new Capsule(start, end, Math.sqrt(largest) + _margin);
        }

        private static function pointOnAxis(centre:Vector.<Number>, axis:int, coordinate:Number):Vector3D
        {
            return new Vector3D(axis == 0 ? coordinate : centre[0], axis == 1 ? coordinate : centre[1],
                    axis == 2 ? coordinate : centre[2]);
        }
    }
}
