package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ConvexShape;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxTree;

    use namespace engine;

    /**
     * Decides whether a part of one model is inside of the other model's closed surface. It is asked only if the two surfaces do not touch,
     * so one point of the part decides. A part that is not closed has no inside.
     *
     * <p>It is asked for all agents that are close but do not touch, so it must mostly end after a few products. If a part is inside, its
     * outermost points are inside of the box around the other model. A ray is cast only for parts that pass this test.</p>
     */
    internal final class ContainmentTest
    {
        // A point of one model, in the space of the model that may be around it.
        private var _point:Vector3D = new Vector3D();

        private var _shape:ConvexShape = new ConvexShape();
        private var _inverse:Placement = new Placement();

        /**
         * Finds a point of a part of one model that is inside of the other. There is none if a tree has no triangles. The surfaces must not touch, and
         * the boxes of two roots must overlap: otherwise the insides would be prepared in vain.
         *
         * @param out receives the point twice, in the world, if there is one; null if only the answer is needed
         * @return whether there is one
         */
        public function findInside(pair:TreePair, out:ClosestPoints):Boolean
        {
            var outer:Placement = pair.b == null ? (isStructureInside(pair) ? pair.placementA : null) : findOuter(pair);
            if (outer != null && out != null)
            {
                out.setPoint(_point);
                out.place(outer);
            }
            return outer != null;
        }

        // Whether the structure that stands for the second model is inside of the first one. It does not touch the surface, so one point of it decides.
        private function isStructureInside(pair:TreePair):Boolean
        {
            var structure:BoundingStructure = pair.pose.place(pair.structureB);
            // The origin of its points is inside of it, and so is a ball around it.
            structure.shapeInto(_shape);
            _point.setTo(_shape.x, _shape.y, _shape.z);
            var box:Box = structure as Box;
            return pair.a.isInside(_point, box == null ? _shape.radius : Math.min(box.halfX, Math.min(box.halfY, box.halfZ)));
        }

        // Returns the placement of the tree that has a part of the other one inside; null if none has.
        private function findOuter(pair:TreePair):Placement
        {
            if (!pair.a.hasTriangles || !pair.b.hasTriangles)
            {
                return null;
            }
            var insideA:Interior = pair.a.prepareInterior();
            var insideB:Interior = pair.b.prepareInterior();
            var treeA:BoxTree = pair.a.boxTree;
            var treeB:BoxTree = pair.b.boxTree;
            var pose:Placement = pair.pose.placement;
            var size:Number = pose.size;
            if (insideA.hasClosedShell && insideB.leastPartExtent * size <= 2 * treeA.radius && findPartInside(treeA, insideA, insideB, pose))
            {
                return pair.placementA;
            }
            if (!insideB.hasClosedShell || insideA.leastPartExtent > 2 * treeB.radius * size)
            {
                return null;
            }
            _inverse.setInverse(pose);
            return findPartInside(treeB, insideB, insideA, _inverse) ? pair.placementB : null;
        }

        // Finds a point of a part of the inner model that is inside of the outer one. Returns whether there is such a point. The pose is that of the
        // inner model in the outer model's space. The numbers (m00 ..., move) transform a point there, relative to the middle of the root's box.
        private function findPartInside(tree:BoxTree, outer:Interior, inner:Interior, pose:Placement):Boolean
        {
            var scale:Number = pose.size;
            var m00:Number = pose.r00 * scale;
            var m01:Number = pose.r01 * scale;
            var m02:Number = pose.r02 * scale;
            var m10:Number = pose.r10 * scale;
            var m11:Number = pose.r11 * scale;
            var m12:Number = pose.r12 * scale;
            var m20:Number = pose.r20 * scale;
            var m21:Number = pose.r21 * scale;
            var m22:Number = pose.r22 * scale;
            var box:Vector.<Number> = tree.boxes;
            var moveX:Number = pose.x - box[0];
            var moveY:Number = pose.y - box[1];
            var moveZ:Number = pose.z - box[2];
            var points:Vector.<Number> = inner.partPoints;
            var length:int = points.length;
            var halfX:Number = box[3];
            var halfY:Number = box[4];
            var halfZ:Number = box[5];
            var x:Number = 0;
            var y:Number = 0;
            var z:Number = 0;
            for (var first:int = 0; first < length; first += PartExtremes.STRIDE)
            {
                var end:int = first + PartExtremes.STRIDE;
                var at:int = first;
                while (at < end)
                {
                    var px:Number = points[at];
                    var py:Number = points[int(at + 1)];
                    var pz:Number = points[int(at + 2)];
                    x = m00 * px + m01 * py + m02 * pz + moveX;
                    if (x > halfX || x < -halfX)
                    {
                        break;
                    }
                    y = m10 * px + m11 * py + m12 * pz + moveY;
                    if (y > halfY || y < -halfY)
                    {
                        break;
                    }
                    z = m20 * px + m21 * py + m22 * pz + moveZ;
                    if (z > halfZ || z < -halfZ)
                    {
                        break;
                    }
                    at += 3;
                }
                if (at == end)
                {
                    _point.x = x + box[0];
                    _point.y = y + box[1];
                    _point.z = z + box[2];
                    if (outer.windingCounter.isInside(_point))
                    {
                        return true;
                    }
                }
            }
            return false;
        }
    }
}
