// A dialog over the page, on the native element: Escape closes it, focus stays inside and goes back afterwards.

import type { ComponentChildren } from 'preact';
import { useEffect, useId, useRef } from 'preact/hooks';
import { dialog, type Dialog } from '../../core/store';
import { Button } from './button';

/** Closes the dialog of this name; another that has opened meanwhile stays. */
export function closeDialog(name: Dialog): void {
  if (dialog.peek() === name) dialog.value = '';
}

interface ModalProps {
  title: string;
  onClose: () => void;
  class?: string;
  children: ComponentChildren;
  /** Buttons at the bottom. */
  actions?: ComponentChildren;
}

export function Modal({ title, onClose, class: extra = '', children, actions }: ModalProps) {
  const element = useRef<HTMLDialogElement>(null);
  const gone = useRef(false);
  const id = useId();
  useEffect(() => {
    const dialog = element.current;
    dialog?.showModal();
    return () => {
      gone.current = true;
      dialog?.close();
    };
  }, []);
  // Browsers close a dialog on Escape by themselves, at times without asking by `cancel` first.
  const closed = () => {
    if (!gone.current) onClose();
  };
  return (
    <dialog
      ref={element}
      class={`modal ${extra}`}
      aria-labelledby={id}
      onCancel={onClose}
      onClose={closed}
      onClick={(event) => {
        if (event.target === element.current) onClose();
      }}
    >
      <div class="modal-inner">
        <header class="modal-head">
          <h2 id={id}>{title}</h2>
          <Button icon="close" label="Close" onClick={onClose} />
        </header>
        <div class="modal-body">{children}</div>
        {actions !== undefined && <footer class="modal-foot row">{actions}</footer>}
      </div>
    </dialog>
  );
}
