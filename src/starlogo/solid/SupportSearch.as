package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ConvexShape;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.BoxTree;

    use namespace engine;

    /**
     * Finds the farthest point of a placed model in a direction. The model is a structure or a tree. Of a tree, the nodes at which a test ends count, or the
     * triangles if they decide. A node reaches only as far as every node above it does, because a test visits it only if those touch.
     *
     * <p>It takes the time of a few branches of the tree: a branch that does not reach as far as the best part so far is left out.</p>
     *
     * @private
     */
    public final class SupportSearch
    {
        // The nodes still to visit, the next one last, and an upper bound of the support of each. Trees may be too deep for recursion.
        private var _nodes:Vector.<int> = new Vector.<int>();
        private var _upperBounds:Vector.<Number> = new Vector.<Number>();

        // A structure that is no tree.
        private var _shape:ConvexShape = new ConvexShape();

        // The direction in the model's space, and the absolute values of its coordinates. These are computed once, because Math.abs() takes the player long.
        private var _direction:Vector3D = new Vector3D();
        private var _absolute:Vector3D = new Vector3D();

        // The farthest point of the present part of a tree.
        private var _part:SupportPoint = new SupportPoint();

        /**
         * Finds how far a model reaches in a direction, and the farthest point. If several are as far, it is the mean of a structure's corners. A tree's
         * point is one of its own: the mean of the corners of one triangle, or the middle of one node's side, nearest to the middle of the tree. The
         * mean of all may belong to nothing: it is between the legs of a table.
         *
         * @param tree the model's tree for the depth; null if a structure represents it
         * @param depth how many levels of the tree count; BoxTree.EXACT if its triangles decide
         * @param structure the structure, in the model's space
         * @param at where the model stands
         * @param direction a unit vector in the world
         * @param out receives the support and the point, in the world
         */
        public function find(tree:BoxTree, depth:int, structure:BoundingStructure, at:Placement, direction:Vector3D, out:SupportPoint):void
        {
            Placement.rotateBack(at, direction, _direction);
            out.support = -Infinity;
            if (tree == null)
            {
                structure.setShape(_shape);
                findOfShape(_shape, _direction, out);
            }
            else
            {
                findOfTree(tree, depth, _direction, out);
            }
            bringBack(direction, at, out);
        }

        // Turns a support and a point in the model's space into those in the world.
        private static function bringBack(direction:Vector3D, at:Placement, out:SupportPoint):void
        {
            var x:Number = at.size * out.x;
            var y:Number = at.size * out.y;
            var z:Number = at.size * out.z;
            out.support = at.x * direction.x + at.y * direction.y + at.z * direction.z + at.size * out.support;
            out.x = at.x + at.r00 * x + at.r01 * y + at.r02 * z;
            out.y = at.y + at.r10 * x + at.r11 * y + at.r12 * z;
            out.z = at.z + at.r20 * x + at.r21 * y + at.r22 * z;
        }

        // The point is the mean of the corners that reach as far as the farthest one, but for a tolerance. They are compared relative to the shape's origin,
        // because far from it rounding would be more than the tolerance.
        private function findOfShape(shape:ConvexShape, direction:Vector3D, out:SupportPoint):void
        {
            var tolerance:Number = Tolerances.SEPARATION * shape.boundingRadius / 2;
            var p:Vector.<Number> = shape.points;
            var i:int = shape.support(direction, 1);
            var ofCore:Number = p[i] * direction.x + p[int(i + 1)] * direction.y + p[int(i + 2)] * direction.z;
            var count:int = 0;
            out.x = out.y = out.z = 0;
            for (i = 0; i < shape.pointsEnd; i += 3)
            {
                if (p[i] * direction.x + p[int(i + 1)] * direction.y + p[int(i + 2)] * direction.z >= ofCore - tolerance)
                {
                    count++;
                    out.x += p[i];
                    out.y += p[int(i + 1)];
                    out.z += p[int(i + 2)];
                }
            }
            divide(out, count);
            out.support = shape.origin.x * direction.x + shape.origin.y * direction.y + shape.origin.z * direction.z + (ofCore + shape.radius);
            out.x += shape.origin.x + shape.radius * direction.x;
            out.y += shape.origin.y + shape.radius * direction.y;
            out.z += shape.origin.z + shape.radius * direction.z;
        }

        private static function divide(sum:SupportPoint, count:int):void
        {
            sum.x /= count;
            sum.y /= count;
            sum.z /= count;
        }

        // Finds the farthest point of a tree in the model's space. Of two nodes, the one that may reach farther comes first.
        private function findOfTree(tree:BoxTree, depth:int, direction:Vector3D, out:SupportPoint):void
        {
            _absolute.x = Math.abs(direction.x);
            _absolute.y = Math.abs(direction.y);
            _absolute.z = Math.abs(direction.z);
            _nodes[0] = 0;
            _upperBounds[0] = supportOfNode(tree.boxes, 0, direction, _absolute);
            for (var top:int = 0; top >= 0; top--)
            {
                var node:int = _nodes[top];
                var upperBound:Number = _upperBounds[top];
                if (upperBound < out.support)
                {
                    continue;
                }
                if (tree.leafUpToDepth[node] < depth)
                {
                    var left:int = tree.left[node];
                    var ofLeft:Number = supportOfNode(tree.boxes, 6 * left, direction, _absolute);
                    var ofRight:Number = supportOfNode(tree.boxes, 6 * left + 6, direction, _absolute);
                    var isLeftFirst:Boolean = ofLeft >= ofRight;
                    var first:Number = isLeftFirst ? ofLeft : ofRight;
                    var second:Number = isLeftFirst ? ofRight : ofLeft;
                    _nodes[top] = isLeftFirst ? left + 1 : left;
                    _nodes[top + 1] = isLeftFirst ? left : left + 1;
                    _upperBounds[top] = second < upperBound ? second : upperBound;
                    _upperBounds[top + 1] = first < upperBound ? first : upperBound;
                    top += 2;
                }
                else if (depth != BoxTree.EXACT)
                {
                    findOfNode(tree.boxes, 6 * node, direction, _part);
                    _part.support = upperBound;
                    takeIfFarther(_part, tree.boxes, out);
                }
                else
                {
                    for (var triangle:int = tree.firstPrimitive[node]; triangle < tree.endPrimitive[node]; triangle++)
                    {
                        if (findOfTriangle(tree, triangle, direction, out.support, _part))
                        {
                            takeIfFarther(_part, tree.boxes, out);
                        }
                    }
                }
            }
        }

        // How far a node's box reaches. Its numbers begin at an index: the middle, and the half-extents.
        private static function supportOfNode(boxes:Vector.<Number>, at:int, direction:Vector3D, absolute:Vector3D):Number
        {
            return boxes[at] * direction.x + boxes[int(at + 1)] * direction.y + boxes[int(at + 2)] * direction.z
                + boxes[int(at + 3)] * absolute.x + boxes[int(at + 4)] * absolute.y + boxes[int(at + 5)] * absolute.z;
        }

        // Finds the farthest point of a node's box. If an edge or a face is across the direction, it is the middle of that.
        private static function findOfNode(boxes:Vector.<Number>, at:int, direction:Vector3D, out:SupportPoint):void
        {
            out.x = boxes[at] + sideOf(direction.x) * boxes[int(at + 3)];
            out.y = boxes[int(at + 1)] + sideOf(direction.y) * boxes[int(at + 4)];
            out.z = boxes[int(at + 2)] + sideOf(direction.z) * boxes[int(at + 5)];
        }

        // Finds how far a triangle reaches, and the mean of the corners that do. Returns false if it reaches less far than needed.
        private static function findOfTriangle(tree:BoxTree, triangle:int, direction:Vector3D, least:Number, out:SupportPoint):Boolean
        {
            var vertices:Vector.<Number> = tree.vertices;
            var a:int = tree.cornerOffsets[int(3 * triangle)];
            var b:int = tree.cornerOffsets[int(3 * triangle + 1)];
            var c:int = tree.cornerOffsets[int(3 * triangle + 2)];
            var ofA:Number = vertices[a] * direction.x + vertices[int(a + 1)] * direction.y + vertices[int(a + 2)] * direction.z;
            var ofB:Number = vertices[b] * direction.x + vertices[int(b + 1)] * direction.y + vertices[int(b + 2)] * direction.z;
            var ofC:Number = vertices[c] * direction.x + vertices[int(c + 1)] * direction.y + vertices[int(c + 2)] * direction.z;
            var farthest:Number = ofA > ofB ? ofA : ofB;
            farthest = farthest > ofC ? farthest : ofC;
            if (farthest < least)
            {
                return false;
            }
            out.support = farthest;
            out.x = out.y = out.z = 0;
            var count:int = 0;
            if (ofA == farthest)
            {
                addCorner(vertices, a, out);
                count++;
            }
            if (ofB == farthest)
            {
                addCorner(vertices, b, out);
                count++;
            }
            if (ofC == farthest)
            {
                addCorner(vertices, c, out);
                count++;
            }
            divide(out, count);
            return true;
        }

        private static function addCorner(vertices:Vector.<Number>, at:int, sum:SupportPoint):void
        {
            sum.x += vertices[at];
            sum.y += vertices[int(at + 1)];
            sum.z += vertices[int(at + 2)];
        }

        // Takes the point of a part of a tree, whose box is the first, if the part reaches farther than the parts before, or as far and the point is nearer
        // to the middle of the tree.
        private static function takeIfFarther(part:SupportPoint, boxes:Vector.<Number>, out:SupportPoint):void
        {
            if (part.support > out.support
                    || part.support == out.support && squaredFromMiddle(boxes, part) < squaredFromMiddle(boxes, out))
            {
                out.support = part.support;
                out.x = part.x;
                out.y = part.y;
                out.z = part.z;
            }
        }

        private static function squaredFromMiddle(boxes:Vector.<Number>, point:SupportPoint):Number
        {
            var toX:Number = point.x - boxes[0];
            var toY:Number = point.y - boxes[1];
            var toZ:Number = point.z - boxes[2];
            return toX * toX + toY * toY + toZ * toZ;
        }

        // Whether an axis points along the direction (1), against it (-1) or across it (0). The cosine of their angle is given.
        private static function sideOf(cosine:Number):int
        {
            return Math.abs(cosine) <= Tolerances.SEPARATION ? 0 : cosine > 0 ? 1 : -1;
        }
    }
}
