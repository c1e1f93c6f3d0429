package
{
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;

    /** A bullet that sweeps: Orange bullets sweep, and hit the thin fence every time. Blue ones do not sweep, and often fly through. Aim. */
    [SWF(width="600", height="400", frameRate="60", backgroundColor="#eef1ee")]
    public class Sweeps extends Land
    {
        private var _collision:Collision = new Collision(new BinCollider());
        private var _fence:Vector.<Agent> = new Vector.<Agent>();
        private var _bullets:Vector.<Agent> = new Vector.<Agent>();
        private var _hits:Object = {orange: 0, blue: 0};
        private var _passes:Object = {orange: 0, blue: 0};

        public function Sweeps()
        {
            for (var i:int = 0; i < 30; i++)
            {
                _fence.push(make("sphere", "posts", 0.6, GREY));
                _fence[i].jumpTo(6, i / 2 - 7, 0);
                _bullets.push(i % 2 == 0 ? make("sphere", "orange", 0.5, ORANGE) : make("sphere", "blue", 0.5, BLUE));
                _bullets[i].sweeps = i % 2 == 0;
                load(_bullets[i], random(-132, -12));
            }
            _collision.onCollision("orange", "posts", hit);
            _collision.onCollision("blue", "posts", hit);
        }

        private function load(bullet:Agent, x:Number):void
        {
            bullet.jumpTo(x, pointerY + (bullet.sweeps ? 1 : -1), 0); // no motion leads there
        }

        private function hit(bullet:Agent, post:Agent):void
        {
            post.color = bullet.color;
            _hits[bullet.breed] += bullet.x > 0 ? 1 : 0; // it may have hit two posts
            load(bullet, random(-132, -12));
        }

        override protected function step():void
        {
            for each (var bullet:Agent in _bullets)
            {
                bullet.moveTo(bullet.x + 2.9, bullet.y, 0);
                if (bullet.x > 12)
                {
                    _passes[bullet.breed]++;
                    load(bullet, random(-132, -12));
                }
            }
            _collision.update(_fence.concat(_bullets));
            draw(_fence.concat(_bullets));
            say("orange " + _hits.orange + " hit, " + _passes.orange + " passed; blue " + _hits.blue + ", " + _passes.blue);
        }
    }
}
